#include "server/InventedSite.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/teaching/DemoClass.h>

#include <algorithm>
#include <utility>

namespace insonate::bench {
namespace {

constexpr int kPerClass = 25, kEarlierAttempts = 10;

/// An instructor, who has chosen the password.
Result<std::string> addInstructor(const InventedSite& site, const std::string& name) {
  const std::string first = std::string(kMadeUpPassword) + ", first";
  const NewPerson person{.name = name, .fullName = "Made-up instructor", .email = "", .role = Role::Instructor};
  const auto added = PeopleStore(site.administrator).add(person, first);
  if (!added) return tl::unexpected(added.error());
  const auto by = site.store.signIn(name, first);
  if (!by) return tl::unexpected(by.error());
  if (auto chosen = PeopleStore(*by).changeOwnPassword(first, kMadeUpPassword); !chosen)
    return tl::unexpected(chosen.error());
  return added->id;
}

Result<void> addClass(InventedSite& site, std::vector<MadeUpClass::Trainee> trainees) {
  const std::string number = std::to_string(site.classes.size() + 1);
  const CohortStore cohorts(site.administrator);
  const auto cohort = cohorts.add("Made-up class " + number);
  if (!cohort) return tl::unexpected(cohort.error());
  MadeUpClass made{.id = cohort->id, .instructor = "made-up-instructor-" + number, .trainees = std::move(trainees)};
  const auto instructor = addInstructor(site, made.instructor);
  if (!instructor) return tl::unexpected(instructor.error());
  if (auto joined = cohorts.join(made.id, *instructor, true); !joined) return joined;
  for (const MadeUpClass::Trainee& trainee : made.trainees)
    if (auto joined = cohorts.join(made.id, trainee.id, false); !joined) return joined;
  if (auto set = cohorts.setCurriculum(made.id, site.curriculum.name, site.curriculum.version); !set) return set;
  site.classes.push_back(std::move(made));
  return {};
}

/// The class of all, which only serves to make people, is deleted.
Result<std::vector<MadeUpClass::Trainee>> takeTrainees(const InventedSite& site) {
  const CohortStore cohorts(site.administrator);
  const auto all = cohorts.cohorts();
  if (!all) return tl::unexpected(all.error());
  std::vector<MadeUpClass::Trainee> trainees;
  for (const Cohort& cohort : *all) {
    const auto members = cohorts.members(cohort.id);
    if (!members) return tl::unexpected(members.error());
    for (const Member& member : *members)
      if (!member.teaches && cohort.name == kDemoClass) trainees.push_back({member.person.id, member.person.name});
    if (auto removed = cohorts.remove(cohort.id, cohort.name); !removed) return tl::unexpected(removed.error());
  }
  return trainees;
}

}  // namespace

Result<InventedSite> makeSite(const CurriculumStore& store, int trainees, int workstations, const Progress& progress) {
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  DemoClassPlan plan{.trainees = trainees, .attempts = kEarlierAttempts};
  plan.until_us = store.guest().now_us();
  if (auto made = makeDemoClass(store, *curriculum, plan, kMadeUpPassword, progress); !made)
    return tl::unexpected(made.error());
  const auto administrator = store.signIn(kDemoAdministrator, kMadeUpPassword);
  if (!administrator) return tl::unexpected(administrator.error());
  InventedSite site{.store = store,
                    .administrator = *administrator,
                    .curriculum = *curriculum,
                    .classes = {},
                    .tokens = {},
                    .trainees = trainees,
                    .attempts = trainees * kEarlierAttempts};
  auto people = takeTrainees(site);
  if (!people) return tl::unexpected(people.error());
  for (std::size_t i = 0; i < people->size(); i += kPerClass) {
    const auto begin = people->begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = people->begin() + static_cast<std::ptrdiff_t>(std::min(people->size(), i + kPerClass));
    if (auto added = addClass(site, {begin, end}); !added) return tl::unexpected(added.error());
  }
  for (int i = 0; i <= workstations; ++i) {
    auto token = Workstations(site.administrator).add("workstation " + std::to_string(i + 1));
    if (!token) return tl::unexpected(token.error());
    site.tokens.push_back(std::move(*token));
  }
  return site;
}

}  // namespace insonate::bench
