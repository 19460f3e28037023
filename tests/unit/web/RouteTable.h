#pragma once

#include "WebRig.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::test {

/// Users in the order of RouteLine::statuses: the trainee whom a page is about, a trainee of the same class, a trainee
/// of another class, the instructor of the class, an instructor of another class, and an administrator.
inline const std::array<std::string, 6> kUsers{"anna", "ben", "carl", "ina", "otto", "admin"};
constexpr std::size_t kSelf = 0;

/// One request to a route of the site, and the status of the answer for each user.
struct RouteLine {
  std::string_view method, route;  ///< of Site::routes()
  /// Address and form of the request. Words in braces stand for data that a request may use up, see FreshTargets.
  std::string path;
  web::Fields form{};
  std::array<int, 6> statuses{};
  /// Status without a session or with a session that has ended; 0: GET leads to the sign-in page, POST is refused.
  int guest = 0;
  int workstation = 0;  ///< status for a workstation with a valid token; 0: that of a guest
};

/// The requests about Anna and the class Spring to each route. A line at the end may end what the lines before need.
std::vector<RouteLine> routeTable(const WebSchool& school);

/// Data made for one request: {person} and {sign-in} are a new trainee of the class Spring, {attempt} and {unproven}
/// new attempts of Anna, {comment} a comment on Anna's attempt, {opening} an opened test, {workstation} a workstation,
/// {name} and {id} are not in use.
class FreshTargets {
 public:
  explicit FreshTargets(const WebSchool& school) : school_(school) {}
  /// Returns the text with the words in braces replaced.
  std::string filledIn(std::string text);
  web::Fields filledIn(web::Fields fields);
  /// The new trainee; null if no text named one.
  const Person* person() const { return person_ ? &*person_ : nullptr; }

 private:
  std::string valueOfWord(const std::string& word);
  const Person& newPerson();

  const WebSchool& school_;
  std::optional<Person> person_;
  std::map<std::string, std::string> values_;
};

}  // namespace insonate::test
