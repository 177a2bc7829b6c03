#include <foldless/report/run_record.h>

namespace foldless {

double decimation_rate(const InputRecord& input, const OutputRecord& output) {
    return input.faces == 0 ? 0.0 : 1.0 - static_cast<double>(output.faces) / static_cast<double>(input.faces);
}

} // namespace foldless
