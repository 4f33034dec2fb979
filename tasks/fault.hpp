#pragma once

#include "striate/config/fault.hpp"

/// What can be wrong with a task script beyond what can be wrong with every file
/// (config/fault.hpp).
namespace striate::tasks::fault {

using namespace config::fault;
using config::Fault;

inline constexpr Fault unknown_action{20};
inline constexpr Fault no_action{21};    ///< a step that does nothing, or an empty list of steps
inline constexpr Fault two_actions{22};  ///< a step that does two things
inline constexpr Fault unknown_condition{23};
inline constexpr Fault bad_condition{24};  ///< no single 'name: value'
inline constexpr Fault unknown_variable{25};
inline constexpr Fault bad_variable{26};  ///< a list, a map, or made of another variable
inline constexpr Fault missing_parameter{27};
inline constexpr Fault unknown_parameter{28};
inline constexpr Fault unknown_file{30};
inline constexpr Fault uses_itself{31};  ///< also through other files
inline constexpr Fault too_large{32};    ///< too many steps with all that is used, or too deep
inline constexpr Fault unreachable{33};
inline constexpr Fault same_motors{34};  ///< two branches of `together` want the same motors
inline constexpr Fault unknown_landmark{35};
inline constexpr Fault key_out_of_place{36};  ///< `with` without `use`, and the like
inline constexpr Fault pauses_for_ever{
    37};  ///< a guard whose condition a standing robot cannot end

}  // namespace striate::tasks::fault
