//! The processor, which must have the instructions that the compiler has used.

/// Ends the program with exit code 1 and one line on stderr if this processor lacks
/// instructions that the compiler was allowed to use.
///
/// To be called first of all. (Not by `is_x86_feature_detected!`, which takes for granted
/// what the compiler may use.)
pub fn check() {
    #[cfg(target_arch = "x86_64")]
    if x86::lacks_any() {
        x86::say_so();
        std::process::exit(1);
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::__cpuid_count;
    use std::io::{Write, stderr};

    /// As it stands: whatever composes a text may already use such an instruction.
    const LINE: &[u8] = b"error: this program was built for another processor, which has instructions that this one lacks; build it again here, or for all by RUSTFLAGS= cargo build\n";

    pub fn say_so() {
        let _ = stderr().write_all(LINE);
    }

    /// Of the bits in three registers, those of the instructions that the compiler may use.
    /// Source: Intel 64 and IA-32 Architectures Software Developer's Manual, CPUID.
    const BASIC_ECX: u32 = mask(&[
        (cfg!(target_feature = "sse3"), 0),
        (cfg!(target_feature = "ssse3"), 9),
        (cfg!(target_feature = "fma"), 12),
        (cfg!(target_feature = "sse4.1"), 19),
        (cfg!(target_feature = "sse4.2"), 20),
        (cfg!(target_feature = "movbe"), 22),
        (cfg!(target_feature = "popcnt"), 23),
        (cfg!(target_feature = "avx"), 28),
        (cfg!(target_feature = "f16c"), 29),
    ]);
    const EXTENDED_EBX: u32 = mask(&[
        (cfg!(target_feature = "bmi1"), 3),
        (cfg!(target_feature = "avx2"), 5),
        (cfg!(target_feature = "bmi2"), 8),
        (cfg!(target_feature = "avx512f"), 16),
        (cfg!(target_feature = "avx512dq"), 17),
        (cfg!(target_feature = "avx512ifma"), 21),
        (cfg!(target_feature = "avx512cd"), 28),
        (cfg!(target_feature = "avx512bw"), 30),
        (cfg!(target_feature = "avx512vl"), 31),
    ]);
    const EXTENDED_ECX: u32 = mask(&[
        (cfg!(target_feature = "avx512vbmi"), 1),
        (cfg!(target_feature = "avx512vbmi2"), 6),
        (cfg!(target_feature = "gfni"), 8),
        (cfg!(target_feature = "vaes"), 9),
        (cfg!(target_feature = "vpclmulqdq"), 10),
        (cfg!(target_feature = "avx512vnni"), 11),
        (cfg!(target_feature = "avx512bitalg"), 12),
        (cfg!(target_feature = "avx512vpopcntdq"), 14),
    ]);

    const fn mask(features: &[(bool, u32)]) -> u32 {
        let (mut mask, mut i) = (0, 0);
        while i < features.len() {
            let (is_used, bit) = features[i];
            mask |= (is_used as u32) << bit;
            i += 1;
        }
        mask
    }

    pub fn lacks_any() -> bool {
        let basic = __cpuid_count(1, 0).ecx;
        // An old processor has no such leaf.
        let [ebx, ecx] = match __cpuid_count(0, 0).eax {
            7.. => [__cpuid_count(7, 0).ebx, __cpuid_count(7, 0).ecx],
            _ => [0, 0],
        };
        let missing = BASIC_ECX & !basic | EXTENDED_EBX & !ebx | EXTENDED_ECX & !ecx;
        missing != 0
    }
}
