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

/// Someone by the name they sign in with, whatever its case, or by id; "": who is signed in. Fails where they are not
/// among those who may be seen.
Result<Person> personNamed(const SignedIn& by, const std::string& nameOrId);
/// Everyone whom an instructor or administrator sees.
Result<std::vector<Person>> visiblePeople(const SignedIn& by);
/// A class by its name, whatever its case, or by id.
Result<Cohort> classNamed(const SignedIn& by, const std::string& nameOrId);
/// Classes in which a person learns, as far as the signed-in user may see them.
Result<std::vector<Cohort>> classesOf(const SignedIn& by, const Person& person);

/// As it was published; version 0: the newest.
Result<Curriculum> publishedCurriculum(const SignedIn& by, const std::string& name, int version);
/// By which a class is taught; fails where it has none yet.
Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort);

/// Standings of all trainees of a class; one access, stored in the store.
Result<std::map<std::string, Standing>> standingsOf(const SignedIn& by, const Cohort& cohort,
                                                    const std::vector<Member>& members);

/// Whatever the case, and Unicode's ways to write one letter.
bool sameName(const std::string& one, const std::string& other);

const char* nameOf(Role role);
const char* nameOf(AttemptState state);
nlohmann::json toJson(const Person& person);

}  // namespace insonate::cli
