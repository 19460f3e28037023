#include "CaseImages.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>
#include <insonate/preparation/CaseReport.h>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

namespace insonate {
namespace {

using nlohmann::json;
using preparation::ReportImage;

constexpr const char* kFacts = "report.json";

std::string_view wordOf(FindingSeverity severity) {
  if (severity == FindingSeverity::kError) return "Error";
  return severity == FindingSeverity::kWarning ? "Warning" : "Note";
}

json jsonOf(const PreparedStudy& prepared, const std::string& id, const std::vector<ReportImage>& images) {
  const VolumeGeometry& g = prepared.patient.ct.geometry;
  json findings = json::array(), files = json::array();
  for (const Finding& finding : prepared.findings)
    findings.push_back({{"severity", wordOf(finding.severity)}, {"text", finding.text}});
  for (const ReportImage& image : images) files.push_back({{"file", image.file}, {"caption", image.caption}});
  return {{"id", id},
          {"title", prepared.patient.manifest.title},
          {"is_fit", isFitForTraining(prepared.findings)},
          {"size", g.size},
          {"spacing_mm", {g.spacing_mm.x, g.spacing_mm.y, g.spacing_mm.z}},
          {"notes", prepared.patient.manifest.importNotes},
          {"warnings", prepared.warnings},
          {"findings", findings},
          {"images", files}};
}

std::optional<json> factsIn(const std::filesystem::path& folder) {
  const auto text = readTextFile(folder / kFacts);
  if (!text) return std::nullopt;
  json facts = json::parse(*text, nullptr, false);
  return facts.is_object() ? std::optional(std::move(facts)) : std::nullopt;
}

std::string listOf(const std::string& heading, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string html = "<h3>" + heading + "</h3><ul>";
  for (const std::string& sentence : sentences) html += "<li>" + escapedMarkup(sentence) + "</li>";
  return html + "</ul>";
}

std::vector<std::string> textsOf(const json& facts, const char* key) {
  std::vector<std::string> texts;
  for (const json& one : facts.value(key, json::array()))
    if (one.is_string()) texts.push_back(one.get<std::string>());
  return texts;
}

std::string sectionOf(const json& facts, const std::string& folder) {
  const std::string id = facts.value("id", ""), reason = facts.value("failure", "");
  if (!reason.empty())
    return "<section><h2>Study " + escapedMarkup(id) + ": not prepared</h2><p>" + escapedMarkup(reason) +
           "</p></section>\n";
  std::string html = "<section><h2>" + escapedMarkup(facts.value("title", "")) + "</h2><p>" +
                     (facts.value("is_fit", false) ? "Fit for training." : "Not fit for training yet.") + "</p><div>";
  for (const json& image : facts.value("images", json::array())) {
    const std::string caption = escapedMarkup(image.value("caption", ""));
    html += "<figure><img loading=\"lazy\" src=\"" + escapedMarkup(folder + "/" + image.value("file", "")) +
            "\" alt=\"" + caption + "\"><figcaption>" + caption + "</figcaption></figure>";
  }
  html += "</div>";
  std::vector<std::string> findings;
  for (const json& finding : facts.value("findings", json::array()))
    findings.push_back(finding.value("severity", "") + ": " + finding.value("text", ""));
  return html + listOf("Findings of the check", findings) + listOf("Please confirm", textsOf(facts, "warnings")) +
         listOf("Changes made by the import", textsOf(facts, "notes")) + "</section>\n";
}

std::string pageOf(const std::vector<std::pair<json, std::string>>& reports) {
  std::size_t failures = 0;
  std::string sections;
  for (const auto& [facts, folder] : reports) {
    failures += facts.contains("failure");
    sections += sectionOf(facts, folder);
  }
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Prepared cases</title><style>"
         "body{background:#14181c;color:#d8dee4;font:15px/1.5 sans-serif;margin:2em}"
         "section{border-top:1px solid #39424b;padding:1em 0}"
         "div{display:flex;flex-wrap:wrap;gap:12px}figure{margin:0}img{height:240px}"
         "figcaption{color:#9aa6b2;font-size:13px}</style></head><body><h1>Prepared cases</h1><p>" +
         std::to_string(reports.size() - failures) + " prepared, " + std::to_string(failures) +
         " not prepared. Open each case under Prepare, confirm what is listed, and publish it.</p>\n" + sections +
         "</body></html>\n";
}

/// Programs that update the page at the same time wait for each other.
class PageLock {
 public:
  explicit PageLock(const std::filesystem::path& file)
      : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ >= 0) ::flock(file_, LOCK_EX);
  }
  ~PageLock() {
    if (file_ >= 0) ::close(file_);
  }
  PageLock(const PageLock&) = delete;
  PageLock& operator=(const PageLock&) = delete;

 private:
  int file_;
};

}  // namespace

Result<void> writeCaseReport(const PreparedStudy& prepared, const std::string& id, const std::filesystem::path& folder,
                             const Progress& progress) {
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    auto images = preparation::writeSlices(prepared.patient, beside);
    if (!images) return tl::unexpected(images.error());
    auto front = preparation::writeFront(prepared.patient, beside);
    if (!front) return tl::unexpected(front.error());
    images->push_back(std::move(*front));
    json facts = jsonOf(prepared, id, *images);
    PatientCase patient = prepared.patient;
    replaceOwnLabels(patient);
    if (auto ultrasound = preparation::writeUltrasound(patient, beside, progress)) {
      std::ranges::move(*ultrasound, std::back_inserter(*images));
      facts = jsonOf(prepared, id, *images);
    } else if (ultrasound.error().message == kCancelled) {
      return tl::unexpected(ultrasound.error());
    } else {
      facts["warnings"].push_back("No ultrasound image: " + ultrasound.error().message);
    }
    return writeAtomically(beside / kFacts, facts.dump(1));
  });
}

Result<void> writeFailureReport(const std::string& id, const std::string& reason, const std::filesystem::path& folder) {
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) {
    return writeAtomically(beside / kFacts, json{{"id", id}, {"failure", reason}}.dump(1));
  });
}

bool isReportOfCase(const std::filesystem::path& folder) {
  const auto facts = factsIn(folder);
  return facts && !facts->contains("failure");
}

Result<void> updateReportPage(const std::filesystem::path& reports) {
  const PageLock lock(reports / ".page.lock");
  std::vector<std::pair<json, std::string>> all;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(reports, failure))
    if (auto facts = factsIn(entry.path())) all.emplace_back(std::move(*facts), entry.path().filename().string());
  std::ranges::sort(all, {}, [](const auto& one) { return std::pair(!one.first.contains("failure"), one.second); });
  return writeAtomically(reports / "index.html", pageOf(all));
}

}  // namespace insonate
