// The processor's floating-point settings that results depend on (rounding, flushing of tiny numbers to zero): a host that
// sets others for its own work must not change a bit of ours. Within its scope they are the defaults of IEEE 754.
#pragma once

#include <cstdint>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

class FloatState {
 public:
#if defined(__x86_64__) || defined(__SSE__)
  FloatState() : before_(__builtin_ia32_stmxcsr()) { __builtin_ia32_ldmxcsr(0x1f80); }
  ~FloatState() { __builtin_ia32_ldmxcsr(before_); }
#elif defined(__aarch64__)
  FloatState() {
    asm volatile("mrs %0, fpcr" : "=r"(before_));
    asm volatile("msr fpcr, %0" : : "r"(std::uint64_t(0)));
  }
  ~FloatState() { asm volatile("msr fpcr, %0" : : "r"(before_)); }
#else
  FloatState() {}
  ~FloatState() {}
#endif
  FloatState(const FloatState&) = delete;
  FloatState& operator=(const FloatState&) = delete;

 private:
#if defined(__aarch64__)
  std::uint64_t before_ = 0;
#else
  [[maybe_unused]] std::uint32_t before_ = 0;
#endif
};

}
