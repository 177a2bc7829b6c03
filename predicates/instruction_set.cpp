#include <foldless/predicates/instruction_set.h>

namespace foldless {

bool is_available(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) {
        return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("avx512f") != 0 &&
               __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
    }
    if (set == InstructionSet::avx2) {
        return __builtin_cpu_supports("avx2") != 0;
    }
#endif
    return set == InstructionSet::scalar;
}

InstructionSet best_instruction_set() {
    static const InstructionSet best = is_available(InstructionSet::avx512) ? InstructionSet::avx512
                                       : is_available(InstructionSet::avx2) ? InstructionSet::avx2
                                                                            : InstructionSet::scalar;
    return best;
}

} // namespace foldless
