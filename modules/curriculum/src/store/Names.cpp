#include "store/Names.h"

namespace insonate::store {

std::string_view nameOf(Role role) {
  switch (role) {
    case Role::Instructor:
      return "instructor";
    case Role::Administrator:
      return "administrator";
    case Role::Trainee:
      break;
  }
  return "trainee";
}

Role roleNamed(std::string_view name) {
  if (name == "administrator") return Role::Administrator;
  return name == "instructor" ? Role::Instructor : Role::Trainee;
}

std::string_view nameOf(AttemptState state) {
  switch (state) {
    case AttemptState::Completed:
      return "completed";
    case AttemptState::Abandoned:
      return "abandoned";
    case AttemptState::Open:
    case AttemptState::Voided:
      break;
  }
  return "open";
}

AttemptState stateNamed(std::string_view name) {
  if (name == "completed") return AttemptState::Completed;
  return name == "abandoned" ? AttemptState::Abandoned : AttemptState::Open;
}

}  // namespace insonate::store
