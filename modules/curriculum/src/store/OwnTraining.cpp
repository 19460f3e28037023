#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/OwnTraining.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <algorithm>

namespace insonate {
namespace {

constexpr const char *kClass = "My training", *kCurriculum = "central_line";
constexpr std::size_t kMaxLetters = 32;

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

Result<void> teachOneself(const SignedIn& me, const Curriculum& curriculum) {
  const auto published =
      PublishedCurricula(me).publish(curriculum.name, curriculum.version, curriculumText(curriculum));
  if (!published) return tl::unexpected(published.error());
  const CohortStore cohorts(me);
  const auto cohort = cohorts.add(kClass);
  if (!cohort) return tl::unexpected(cohort.error());
  if (auto joined = cohorts.join(cohort->id, me.person().id, false); !joined) return joined;
  return cohorts.setCurriculum(cohort->id, curriculum.name, curriculum.version);
}

}  // namespace

std::string signInNameOf(const std::string& fullName) {
  std::string name;
  for (const char c : fullName) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (isPlain(lower))
      name += lower;
    else if (c == ' ' && !name.empty() && name.back() != '.')
      name += '.';
  }
  name.resize(std::min(name.size(), kMaxLetters));
  while (!name.empty() && name.back() == '.') name.pop_back();
  return name.empty() ? "me" : name;
}

Result<SignedIn> setUpOwnTraining(const CurriculumStore& store, const std::string& fullName,
                                  const std::string& password) {
  if (fullName.empty()) return fail("Enter your name; it is shown with your results.");
  const auto curriculum = loadCurriculum(kCurriculum);
  if (!curriculum) return tl::unexpected(curriculum.error());
  auto me = store.createFirstAdministrator({.name = signInNameOf(fullName), .fullName = fullName}, password);
  if (!me) return me;
  if (auto taught = teachOneself(*me, *curriculum); !taught) return tl::unexpected(taught.error());
  return me;
}

}  // namespace insonate
