#include <foldless/tools/threads.h>

#include <algorithm>
#include <thread>

namespace foldless {

int threads_to_use(std::optional<int> asked_for) {
    return asked_for.value_or(std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

} // namespace foldless
