#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace insonate::cli {

/// Finds a person by id or by sign-in name, ignoring case; "" returns the signed-in user. Fails if the signed-in user
/// may not see the person.
Result<Person> personNamed(const SignedIn& by, const std::string& nameOrId);
/// Returns everyone whom the signed-in instructor or administrator may see.
Result<std::vector<Person>> visiblePeople(const SignedIn& by);
/// Finds a class by id or by name, ignoring case.
Result<Cohort> classNamed(const SignedIn& by, const std::string& nameOrId);
/// Returns the classes of which the person is a trainee and that the signed-in user may see.
Result<std::vector<Cohort>> classesOf(const SignedIn& by, const Person& person);

/// Returns a published version of a curriculum; version 0: the newest.
Result<Curriculum> publishedCurriculum(const SignedIn& by, const std::string& name, int version);
/// Returns the curriculum assigned to a class; fails if none is assigned.
Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort);

/// Returns the progress (Standing) of all trainees of a class, by Person::id. The audit log counts this as one access.
Result<std::map<std::string, Standing>> standingsOf(const SignedIn& by, const Cohort& cohort,
                                                    const std::vector<Member>& members);

/// Compares names, ignoring case and Unicode compatibility forms.
bool sameName(const std::string& one, const std::string& other);

const char* nameOf(Role role);
const char* nameOf(AttemptState state);
nlohmann::json toJson(const Person& person);

}  // namespace insonate::cli
