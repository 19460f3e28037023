#include "SlicerSegmentation.h"

#include "LabelNames.h"
#include "NrrdWriter.h"
#include "OwnNumbers.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace insonate {
namespace {

struct Segment {
  std::string name;
  int layer = 0;
  long value = 0;
  std::uint8_t label = 0;
  bool lost = false;    ///< no number was free for it
  std::string known{};  ///< see ReadStructure
};

constexpr std::string_view kOwnTag = "Insonate.Label:", kStatusTag = "Segmentation.Status:";
constexpr std::array<std::string_view, 4> kStatus{"notstarted", "inprogress", "completed", "flagged"};

std::string colorText(const LabelColor& color) {
  std::string text;
  for (int c = 0; c < 3; ++c) text += (c ? " " : "") + exactDecimal(color[c] / 255.0);
  return text;
}

/// Three numbers from 0 to 1; none for other texts.
std::optional<LabelColor> colorFromText(const std::string& text) {
  LabelColor color{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::uint8_t& part : color) {
    while (at < end && *at == ' ') ++at;
    double share = 0;
    const auto [rest, error] = std::from_chars(at, end, share);
    if (error != std::errc() || !(share >= 0 && share <= 1)) return std::nullopt;
    part = static_cast<std::uint8_t>(std::lround(share * 255));
    at = rest;
  }
  return color;
}

/// Several segments may be one structure: it has the color of the first.
LabelColors colorsOf(const std::vector<Segment>& segments, const std::map<std::string, std::string>& metadata) {
  LabelColors all;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    const auto found = metadata.find("Segment" + std::to_string(n) + "_Color");
    const auto color = found == metadata.end() ? std::nullopt : colorFromText(found->second);
    if (color && !segments[n].lost) all.try_emplace(segments[n].label, *color);
  }
  std::erase_if(all, [](const auto& one) { return one.second == caseLabelColor({}, one.first); });
  return all;
}

/// A label of the author has the code of its tissue.
std::string tagsOfLabel(const CaseManifest& manifest, std::uint8_t label) {
  const LabelState state = stateOf(manifest.states, label, true);
  std::string tags = std::string(kStatusTag) + std::string(kStatus[static_cast<std::size_t>(state)]) + "|";
  if (manifest.ownLabels.contains(label)) tags += std::string(kOwnTag) + std::to_string(label) + "|";
  const std::uint8_t tissue = tissueOf(manifest.ownLabels, label);
  if (tissue < kLabelCount)
    tags +=
        "TerminologyEntry:Segmentation category and type - 3D Slicer General Anatomy list"
        "~SCT^85756007^Tissue~SCT^" +
        std::string(labelTable()[tissue].snomedCode) + "^" + std::string(labelTable()[tissue].snomedMeaning) +
        "~^^~Anatomic codes - DICOM master list~^^~^^|";
  return tags;
}

long integerOf(const std::map<std::string, std::string>& metadata, const std::string& key, long otherwise) {
  const auto found = metadata.find(key);
  if (found == metadata.end()) return otherwise;
  long value = otherwise;
  std::from_chars(found->second.data(), found->second.data() + found->second.size(), value);
  return value;
}

/// The SNOMED code of the type in "TerminologyEntry:context~category~SCT^code^meaning~...".
std::string typeCodeOf(const std::string& tags) {
  const std::size_t entry = tags.find("TerminologyEntry:");
  if (entry == std::string::npos) return {};
  std::size_t field = entry;
  for (int tilde = 0; tilde < 2; ++tilde) {
    field = tags.find('~', field);
    if (field == std::string::npos) return {};
    ++field;
  }
  const std::size_t code = tags.find('^', field);
  const std::size_t end = code == std::string::npos ? code : tags.find('^', code + 1);
  return end == std::string::npos ? std::string{} : tags.substr(code + 1, end - code - 1);
}

/// Value of a tag: the text after it, up to the separator.
std::string_view tagIn(std::string_view tags, std::string_view tag) {
  const std::size_t at = tags.find(tag);
  if (at == std::string_view::npos) return {};
  tags.remove_prefix(at + tag.size());
  return tags.substr(0, tags.find('|'));
}

/// Number of a label that an author named in this program.
std::optional<std::uint8_t> ownLabelOf(std::string_view tags) {
  const std::string_view text = tagIn(tags, kOwnTag);
  int label = 0;
  std::from_chars(text.data(), text.data() + text.size(), label);
  return label > 0 && label < 256 && isOwnLabel(static_cast<std::uint8_t>(label))
             ? std::optional(static_cast<std::uint8_t>(label))
             : std::nullopt;
}

/// Finds the label by the author's number, by terminology, by name; else takes a free number.
void giveLabel(Segment& s, const std::string& tags, OwnNumbers& numbers, LabelReadResult& result) {
  const auto code = labelFromSnomed(typeCodeOf(tags));
  const auto own = ownLabelOf(tags);
  s.known = knownStructure(s.name, typeCodeOf(tags));
  const std::string what = "The segment \"" + s.name + "\" (number " + std::to_string(s.value) + ")";
  if (own) {
    s.label = *own;
    const std::string name = tidyLabelName(s.name);
    result.own[s.label] = {name == labelName(s.label) ? "" : name, code.value_or(kSoftTissue)};
  } else if (const auto known = code ? code : labelFromAnyName(s.name)) {
    s.label = *known;
    if (s.label != s.value)
      result.notes.push_back(what + " is read as " + labelName(s.label) + " (" + std::to_string(s.label) + ").");
  } else if (s.value >= kLabelCount && s.value <= kLastOwnLabel && s.name == "label " + std::to_string(s.value)) {
    s.label = numbers.take(s.value);  // its meaning is unknown
  } else {
    s.label = numbers.take(s.value);
    s.lost = !isOwnLabel(s.label);
    result.notes.push_back(unknownStructure(what, s.label));
    if (s.lost) return;
    result.own[s.label] = {tidyLabelName(s.name), kSoftTissue};
    result.foreign.insert(s.label);
  }
  const auto status = std::ranges::find(kStatus, tagIn(tags, kStatusTag));
  if (status != kStatus.end()) result.states.try_emplace(s.label, static_cast<LabelState>(status - kStatus.begin()));
}

/// In a file of several layers without their names, each segment has a layer, in their order.
std::vector<Segment> segmentsOf(const RawVolume& raw, LabelReadResult& result) {
  const auto& metadata = raw.metadata;
  const auto text = [&](std::size_t n, const char* field) {
    const auto found = metadata.find("Segment" + std::to_string(n) + "_" + field);
    return found == metadata.end() ? std::string{} : found->second;
  };
  std::vector<Segment> segments;
  OwnNumbers numbers;
  for (std::size_t n = 0; metadata.contains("Segment" + std::to_string(n) + "_ID"); ++n) {
    const std::string key = "Segment" + std::to_string(n) + "_";
    segments.push_back({text(n, "Name"),
                        static_cast<int>(integerOf(metadata, key + "Layer", raw.components > 1 ? long(n) : 0)),
                        integerOf(metadata, key + "LabelValue", 1)});
    if (const auto own = ownLabelOf(text(n, "Tags"))) numbers.keep(*own);
  }
  for (std::size_t n = 0; n < segments.size(); ++n) giveLabel(segments[n], text(n, "Tags"), numbers, result);
  return segments;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> slicerFields(const PatientCase& patient) {
  std::array<bool, 256> used{};
  for (const std::uint8_t v : patient.labels.voxels) used[v] = true;
  // Every segment has the extent of the whole grid, since segments that share a layer must have the same extent.
  std::string extent;
  for (int n : patient.labels.geometry.size) extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(n - 1);

  std::vector<std::pair<std::string, std::string>> fields;
  int segment = 0;
  for (int number = 1; number < 256; ++number) {
    if (!used[number]) continue;
    const auto label = static_cast<std::uint8_t>(number);
    const std::string key = "Segment" + std::to_string(segment++) + "_";
    fields.insert(fields.end(), {{key + "ID", "Segment_" + std::to_string(label)},
                                 {key + "Name", labelName(patient.manifest.ownLabels, label)},
                                 {key + "NameAutoGenerated", "0"},
                                 {key + "Color", colorText(caseLabelColor(patient.colors, label))},
                                 {key + "ColorAutoGenerated", "0"},
                                 {key + "Extent", extent},
                                 {key + "Layer", "0"},
                                 {key + "LabelValue", std::to_string(label)},
                                 {key + "Tags", tagsOfLabel(patient.manifest, label)}});
  }
  fields.insert(fields.end(), {{"Segmentation_ContainedRepresentationNames", "Binary labelmap|"},
                               {"Segmentation_ConversionParameters", ""},
                               {"Segmentation_MasterRepresentation", "Binary labelmap"},
                               {"Segmentation_SourceRepresentation", "Binary labelmap"},
                               {"Segmentation_ReferenceImageExtentOffset", "0 0 0"}});
  return fields;
}

bool isSlicerSegmentation(const std::map<std::string, std::string>& metadata) {
  return metadata.contains("Segment0_ID") || metadata.contains("Segmentation_MasterRepresentation") ||
         metadata.contains("Segmentation_SourceRepresentation");
}

Result<LabelReadResult> fromSlicerSegmentation(const RawVolume& raw, const VolumeGeometry& geometry,
                                               const StructureChoices* choices) {
  LabelReadResult result{LabelMap(geometry), {}};
  const std::vector<Segment> segments = segmentsOf(raw, result);
  result.colors = colorsOf(segments, raw.metadata);
  for (const Segment& s : segments) {
    result.structures.push_back({static_cast<std::int32_t>(s.value), s.name, s.label, s.known});
    if (choices && !isTaken(result.structures.back(), *choices, true))
      result.structures.back().state = StructureState::kLeftOut;
  }
  if (choices) result.parts = Volume<std::uint16_t>(geometry);
  std::set<std::pair<int, long>> orphans;
  std::size_t overlaps = 0;
  std::vector<std::map<long, const Segment*>> layers(raw.components);
  for (const Segment& s : segments) {
    if (s.layer < 0 || s.layer >= raw.components)
      return fail("The segment \"" + s.name + "\" is in layer " + std::to_string(s.layer) + ", but the file has " +
                  std::to_string(raw.components) + ". Save the segmentation again.");
    layers[s.layer][s.value] = &s;
  }
  for (std::size_t v = 0; v < result.labels.voxels.size(); ++v) {
    const Segment* last = nullptr;
    bool overlap = false;
    for (int layer = 0; layer < raw.components; ++layer) {
      const long value = static_cast<long>(raw.values[v * raw.components + layer]);
      if (value == 0) continue;
      const auto found = layers[layer].find(value);
      if (found == layers[layer].end()) {
        orphans.insert({layer, value});
        continue;
      }
      if (result.structures[found->second - segments.data()].state == StructureState::kLeftOut) continue;
      overlap = overlap || (last && last->label != found->second->label);
      if (!last || found->second > last) last = found->second;
    }
    overlaps += overlap;
    if (last) result.labels.voxels[v] = last->label;
    if (last && choices) result.parts.voxels[v] = static_cast<std::uint16_t>(last - segments.data() + 1);
  }
  for (const auto& [layer, value] : orphans)
    result.notes.push_back("The number " + std::to_string(value) +
                           " in the file belongs to no segment and was ignored.");
  if (overlaps > 0)
    result.notes.push_back(std::to_string(overlaps) +
                           " voxels belong to several segments; each gets the label of the last one.");
  return result;
}

}  // namespace insonate
