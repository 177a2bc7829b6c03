#include <foldless/report/version.h>

namespace foldless {

std::string_view version() {
    return FOLDLESS_VERSION;
}

} // namespace foldless
