#pragma once

#include <insonate/core/Result.h>
#include <insonate/site/PublishedCases.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Writes the list of published cases as JSON, without their folders.
std::string caseListText(const std::vector<PublishedCase>& cases);
/// Reads this list, and leaves out entries with impossible ids or names of files, since both become names of folders
/// and files. Fails if the text is no such list.
Result<std::vector<PublishedCase>> readCaseList(const std::string& text);

/// Computes PublishedCase::id. `content` is CaseVersion::content.
std::string caseId(const std::string& title, const std::string& content);
/// Tells whether a text has the form of PublishedCase::id, and so can be the name of a folder.
bool isCaseId(std::string_view text);

}  // namespace insonate
