#define HWY_WANT_AVX3_DL 1  // as all of the vector code: the answer is to be the same

#include "striate/base/instruction_set.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/base/instruction_set.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::HWY_NAMESPACE {

const char* InstructionSet() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace striate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate {

HWY_EXPORT(InstructionSet);

std::string_view instruction_set() {
  return HWY_DYNAMIC_DISPATCH(InstructionSet)();
}

}  // namespace striate
#endif
