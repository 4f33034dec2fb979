#pragma once

#include <string>

/// System calls of this process that write into one folder can be made to fail, one by one: the
/// functions by which libraries make them are defined in failing_calls.cpp and come before the C
/// library's.
namespace striate::failing_calls {

/// From now on the call of this number, counted from 1, into files below the folder fails with
/// this errno; it is done, and all others are, as ever.
/// @param keeps all calls from this one on fail: a disk that stays full or broken
void arm(const std::string& folder, long number, int error, bool keeps);
/// How many calls there have been since.
long count();

}  // namespace striate::failing_calls
