#include "CaseMessages.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/core/Fingerprint.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace insonate {
namespace {

using nlohmann::json;

constexpr std::size_t kIdDigits = 16;

json jsonOf(const PublishedCase& one) {
  json files = json::array();
  for (const PublishedCase::File& file : one.files) files.push_back({{"name", file.name}, {"bytes", file.size_bytes}});
  return {{"id", one.id},
          {"title", one.title},
          {"version", one.version.number},
          {"content", one.version.content},
          {"date", one.version.date},
          {"files", std::move(files)}};
}

PublishedCase caseFrom(const json& entry) {
  PublishedCase one;
  one.id = entry.at("id"), one.title = entry.at("title");
  one.version.number = entry.at("version"), one.version.content = entry.at("content");
  one.version.date = entry.at("date");
  for (const json& file : entry.at("files"))
    one.files.push_back({.name = file.at("name"), .size_bytes = file.at("bytes")});
  return one;
}

bool isPossible(const PublishedCase& one) {
  const auto isCaseFile = [](const PublishedCase::File& file) {
    return std::ranges::find(caseFileNames(), file.name) != caseFileNames().end() && file.size_bytes > 0;
  };
  return isCaseId(one.id) && !one.files.empty() && std::ranges::all_of(one.files, isCaseFile);
}

}  // namespace

std::string caseListText(const std::vector<PublishedCase>& cases) {
  json list = json::array();
  for (const PublishedCase& one : cases) list.push_back(jsonOf(one));
  return json{{"cases", std::move(list)}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<std::vector<PublishedCase>> readCaseList(const std::string& text) {
  try {
    std::vector<PublishedCase> cases;
    const json list = json::parse(text);
    for (const json& entry : list.at("cases"))
      if (PublishedCase one = caseFrom(entry); isPossible(one)) cases.push_back(std::move(one));
    return cases;
  } catch (const json::exception&) {
  }
  return fail("The list of cases cannot be read. Install the same version of Insonate on workstation and server.");
}

std::string caseId(const std::string& title, const std::string& content) {
  Fingerprint fingerprint;
  fingerprint.add(content), fingerprint.add(title);
  return fingerprint.text();
}

bool isCaseId(std::string_view text) {
  return text.size() == kIdDigits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace insonate
