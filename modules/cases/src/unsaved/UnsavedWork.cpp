#include "files/ManifestJson.h"

#include <insonate/cases/UnsavedWork.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

// The file: kMagic, checksum of all that follows, size of the unpacked content, packed content. The content: size of
// the JSON text, JSON text, runs.
constexpr std::string_view kMagic = "INSONATE UNSAVED 1\n";
constexpr std::string_view kAnyVersion = "INSONATE UNSAVED ";
constexpr std::size_t kSum = 4, kSize = 8;

template <class T>
std::uint32_t sumOf(std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return std::uint32_t(crc32_z(crc32_z(0, nullptr, 0), data, bytes.size()));
}

template <std::size_t kBytes>
void append(std::string& text, std::uint64_t number) {
  for (std::size_t n = 0; n < kBytes; ++n) text.push_back(char(number >> (8 * n) & 0xff));
}

template <std::size_t kBytes>
std::uint64_t numberAt(std::string_view text, std::size_t at) {
  std::uint64_t number = 0;
  for (std::size_t n = 0; n < kBytes; ++n) number |= std::uint64_t(std::uint8_t(text[at + n])) << (8 * n);
  return number;
}

json toJson(const LabelColors& colors) {
  json list = json::array();
  for (const auto& [label, color] : colors) list.push_back({label, color[0], color[1], color[2]});
  return list;
}

LabelColors colorsFrom(const json& list) {
  LabelColors colors;
  for (const json& entry : list) colors[entry.at(0)] = {entry.at(1), entry.at(2), entry.at(3)};
  return colors;
}

json toJson(const UnsavedWork& work) {
  return {{"folder", work.folder},
          {"time_s", work.time_s},
          {"strokes", work.strokes},
          {"steps", work.steps},
          {"recipe", work.recipe},
          {"size", work.sums.size},
          {"ct", work.sums.ct},
          {"labels", work.sums.labels},
          {"all_labels", work.hasAllLabels},
          {"before", manifestToJson(work.before)},
          {"after", manifestToJson(work.after)},
          {"colors_before", toJson(work.colorsBefore)},
          {"colors_after", toJson(work.colorsAfter)}};
}

/// Throws on JSON of other types, which only a damaged file contains.
Result<UnsavedWork> workFrom(const json& document) {
  UnsavedWork work;
  work.folder = document.at("folder").get<std::string>();
  work.time_s = document.at("time_s").get<std::int64_t>();
  work.strokes = document.at("strokes").get<int>();
  work.steps = document.at("steps").get<int>();
  work.recipe = document.at("recipe").get<std::string>();
  work.sums.size = document.at("size").get<std::array<int, 3>>();
  work.sums.ct = document.at("ct").get<std::uint32_t>();
  work.sums.labels = document.at("labels").get<std::uint32_t>();
  work.hasAllLabels = document.at("all_labels").get<bool>();
  work.colorsBefore = colorsFrom(document.at("colors_before"));
  work.colorsAfter = colorsFrom(document.at("colors_after"));
  std::vector<std::string> notes;
  auto before = manifestFromJson(document.at("before").get<std::string>(), notes);
  auto after = manifestFromJson(document.at("after").get<std::string>(), notes);
  if (!before) return tl::unexpected(before.error());
  if (!after) return tl::unexpected(after.error());
  work.before = std::move(*before), work.after = std::move(*after);
  return work;
}

tl::unexpected<Error> damaged(const fs::path& file) {
  return fail("The unsaved work in " + file.string() + " is incomplete or damaged and cannot be restored.");
}

bool hasSamePlaces(const CaseManifest& a, const CaseManifest& b) {
  // Each reading of a file straightens directions by a rounding error.
  constexpr double kRounding = 1e-9;
  const auto isSamePose = [](const StartPose& x, const StartPose& y) {
    return x.name == y.name && x.position_mm == y.position_mm && norm(x.axial - y.axial) < kRounding &&
           norm(x.lateral - y.lateral) < kRounding;
  };
  return a.targets == b.targets && a.vessels == b.vessels && a.landmarks == b.landmarks &&
         a.difficulty == b.difficulty && std::ranges::equal(a.startPoses, b.startPoses, isSamePose);
}

/// Sets `present` to `after` if the work has changed it.
template <class T>
void apply(const T& before, const T& after, T& present) {
  if (!(before == after)) present = after;
}

template <class T>
void applyEach(const std::map<std::uint8_t, T>& before, const std::map<std::uint8_t, T>& after,
               std::map<std::uint8_t, T>& present) {
  for (const auto& [label, value] : before)
    if (!after.contains(label)) present.erase(label);
  for (const auto& [label, value] : after)
    if (const auto was = before.find(label); was == before.end() || !(was->second == value)) present[label] = value;
}

}  // namespace

CaseSums sumsOf(const PatientCase& patient) {
  return {patient.ct.geometry.size, sumOf(std::span(patient.ct.voxels)), sumOf(std::span(patient.labels.voxels))};
}

UnsavedParts partsOf(const UnsavedWork& work) {
  const CaseManifest &a = work.before, &b = work.after;
  UnsavedParts parts;
  parts.labels = !work.runs.empty();
  parts.title = a.title != b.title;
  parts.places = !hasSamePlaces(a, b);
  parts.terms = a.ownLabels != b.ownLabels || a.states != b.states;
  parts.colors = work.colorsBefore != work.colorsAfter;
  parts.shown = a.shown != b.shown;
  return parts;
}

bool isUnchanged(const UnsavedWork& work, const CaseManifest& manifest, const LabelColors& colors) {
  const CaseManifest& then = work.before;
  return then.title == manifest.title && hasSamePlaces(then, manifest) && then.ownLabels == manifest.ownLabels &&
         then.states == manifest.states && then.shown == manifest.shown && work.colorsBefore == colors;
}

void applyValues(const UnsavedWork& work, CaseManifest& manifest, LabelColors& colors) {
  const CaseManifest &a = work.before, &b = work.after;
  apply(a.title, b.title, manifest.title);
  apply(a.difficulty, b.difficulty, manifest.difficulty);
  apply(a.targets, b.targets, manifest.targets);
  apply(a.vessels, b.vessels, manifest.vessels);
  apply(a.startPoses, b.startPoses, manifest.startPoses);
  apply(a.landmarks, b.landmarks, manifest.landmarks);
  applyEach(a.ownLabels, b.ownLabels, manifest.ownLabels);
  applyEach(a.states, b.states, manifest.states);
  applyEach(a.shown, b.shown, manifest.shown);
  applyEach(work.colorsBefore, work.colorsAfter, colors);
}

Result<LabelMap> withUnsavedLabels(const UnsavedWork& work, const LabelMap& labels) {
  LabelMap with = work.hasAllLabels ? LabelMap(labels.geometry) : labels;
  if (auto ok = applyRuns(work.runs, with.voxels); !ok) return tl::unexpected(ok.error());
  return with;
}

Result<void> writeUnsavedWork(const UnsavedWork& work, const fs::path& file) {
  const std::string text = toJson(work).dump(-1, ' ', false, json::error_handler_t::replace);
  std::string content;
  content.reserve(kSize + text.size() + work.runs.size());
  append<kSize>(content, text.size());
  content += text;
  content.append(work.runs.begin(), work.runs.end());
  uLongf packed = compressBound(content.size());
  std::string body;
  append<kSize>(body, content.size());
  body.resize(kSize + packed);
  const auto* from = reinterpret_cast<const Bytef*>(content.data());
  if (compress2(reinterpret_cast<Bytef*>(body.data()) + kSize, &packed, from, content.size(), Z_BEST_SPEED) != Z_OK)
    return fail("There is not enough memory to keep the unsaved work.");
  body.resize(kSize + packed);
  std::string bytes(kMagic);
  append<kSum>(bytes, sumOf(std::span<const char>(body)));
  return writeAtomically(file, bytes + body);
}

Result<UnsavedWork> readUnsavedWork(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail("Could not read " + file.string() + ".");
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.starts_with(kAnyVersion) && bytes.size() > kMagic.size() && !bytes.starts_with(kMagic))
    return fail("The unsaved work in " + file.string() + " was kept by a newer version of Insonate.");
  if (!bytes.starts_with(kMagic) || bytes.size() < kMagic.size() + kSum + kSize) return damaged(file);
  const std::string_view body = std::string_view(bytes).substr(kMagic.size() + kSum);
  if (numberAt<kSum>(bytes, kMagic.size()) != sumOf(std::span(body))) return damaged(file);
  constexpr std::uint64_t kLargestRatio = 1100;  // zlib packs at most 1032 bytes into one
  uLongf size = numberAt<kSize>(body, 0);
  if (size > body.size() * kLargestRatio) return damaged(file);
  std::string content(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(body.data()) + kSize;
  if (uncompress(reinterpret_cast<Bytef*>(content.data()), &size, from, body.size() - kSize) != Z_OK ||
      size != content.size() || size < kSize)
    return damaged(file);
  const std::uint64_t text = numberAt<kSize>(content, 0);
  if (text > content.size() - kSize) return damaged(file);
  try {
    auto work = workFrom(json::parse(content.begin() + kSize, content.begin() + std::ptrdiff_t(kSize + text)));
    if (work) work->runs.assign(content.begin() + std::ptrdiff_t(kSize + text), content.end());
    return work;
  } catch (const json::exception&) {
    return damaged(file);
  }
}

}  // namespace insonate
