/// \file
/// Which vector instructions the processor has.
#pragma once

namespace foldless {

/// What a kernel is compiled for. All give the same bytes: no multiply-adds, and every operation rounds correctly.
enum class InstructionSet {
    scalar, ///< one double at a time, on any processor
    avx2,   ///< four
    avx512, ///< four, with more registers and with masks: AVX-512 F, DQ and VL
};

/// Whether this processor, with its operating system, can run such a kernel.
[[nodiscard]] bool is_available(InstructionSet set);

/// The fastest that is available; the processor is asked once.
[[nodiscard]] InstructionSet best_instruction_set();

} // namespace foldless
