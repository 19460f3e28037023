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
  std::erase_if(all, [](const auto& one) { return isUsualColor(one.first, one.second); });
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
std::vector<Segment> segmentsOf(const VolumeHeader& header, LabelReadResult& result) {
  const auto& metadata = header.metadata;
  const auto text = [&](std::size_t n, const char* field) {
    const auto found = metadata.find("Segment" + std::to_string(n) + "_" + field);
    return found == metadata.end() ? std::string{} : found->second;
  };
  std::vector<Segment> segments;
  OwnNumbers numbers;
  for (std::size_t n = 0; metadata.contains("Segment" + std::to_string(n) + "_ID"); ++n) {
    const std::string key = "Segment" + std::to_string(n) + "_";
    segments.push_back({text(n, "Name"),
                        static_cast<int>(integerOf(metadata, key + "Layer", header.components > 1 ? long(n) : 0)),
                        integerOf(metadata, key + "LabelValue", 1)});
    if (const auto own = ownLabelOf(text(n, "Tags"))) numbers.keep(*own);
  }
  for (std::size_t n = 0; n < segments.size(); ++n) giveLabel(segments[n], text(n, "Tags"), numbers, result);
  return segments;
}

/// Flattens the layers: of several segments in a voxel, the last in the file counts.
class Flattening {
 public:
  Flattening(const VolumeGeometry& geometry, int components, bool tracksParts)
      : labels_(geometry), parts_(geometry), layers_(std::size_t(components)), tracksParts_(tracksParts) {}

  void addSegment(const Segment& segment, std::uint16_t number, bool isRead) {
    layers_[std::size_t(segment.layer)][segment.value] = {number, segment.label, isRead};
  }

  void take(std::size_t first, std::span<const float> values) {
    const std::size_t layers = layers_.size(), count = values.size() / layers;
    std::uint8_t* const labels = labels_.at(first / layers, count);
    std::uint16_t* const parts = tracksParts_ ? parts_.at(first / layers, count) : nullptr;
    for (std::size_t v = 0; v < count; ++v) {
      const Place last = placeOf(values.subspan(v * layers, layers));
      labels[v] = last.label;
      if (parts) parts[v] = last.number;
    }
  }

  void finish(LabelReadResult& result) {
    result.labels = labels_.take();
    if (tracksParts_) result.parts = parts_.take();
    for (const auto& [layer, value] : orphans_)
      result.notes.push_back("The number " + std::to_string(value) +
                             " in the file belongs to no segment and was ignored.");
    if (overlaps_ > 0)
      result.notes.push_back(std::to_string(overlaps_) +
                             " voxels belong to several segments; each gets the label of the last one.");
  }

 private:
  struct Place {
    std::uint16_t number = 0;  ///< counted from 1
    std::uint8_t label = 0;
    bool isRead = false;
  };

  Place placeOf(std::span<const float> values) {
    Place last;
    bool overlap = false;
    for (std::size_t layer = 0; layer < values.size(); ++layer) {
      const long value = static_cast<long>(values[layer]);
      if (value == 0) continue;
      const auto found = layers_[layer].find(value);
      if (found == layers_[layer].end()) {
        orphans_.insert({layer, value});
        continue;
      }
      const Place& here = found->second;
      if (!here.isRead) continue;
      overlap = overlap || (last.number != 0 && last.label != here.label);
      if (here.number > last.number) last = here;
    }
    overlaps_ += overlap;
    return last;
  }

  ArrivingVolume<std::uint8_t> labels_;
  ArrivingVolume<std::uint16_t> parts_;
  std::vector<std::map<long, Place>> layers_;
  bool tracksParts_;
  std::set<std::pair<std::size_t, long>> orphans_;
  std::size_t overlaps_ = 0;
};

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

Result<LabelReadResult> readSlicerSegmentation(const std::filesystem::path& file, const VolumeHeader& header,
                                               const VolumeGeometry& geometry, const StructureChoices* choices) {
  LabelReadResult result;
  const std::vector<Segment> segments = segmentsOf(header, result);
  result.colors = colorsOf(segments, header.metadata);
  Flattening flattening(geometry, header.components, choices != nullptr);
  for (const Segment& s : segments) {
    result.structures.push_back({static_cast<std::int32_t>(s.value), s.name, s.label, s.known});
    ReadStructure& structure = result.structures.back();
    if (choices && !isTaken(structure, *choices, true)) structure.state = StructureState::kLeftOut;
    if (s.layer < 0 || s.layer >= header.components)
      return fail("The segment \"" + s.name + "\" is in layer " + std::to_string(s.layer) + ", but the file has " +
                  std::to_string(header.components) + ". Save the segmentation again.");
    flattening.addSegment(s, static_cast<std::uint16_t>(result.structures.size()),
                          structure.state != StructureState::kLeftOut);
  }
  const auto read =
      readVolumeBlocks(file, [&](std::size_t first, std::span<const float> values) { flattening.take(first, values); });
  if (!read) return tl::unexpected(read.error());
  flattening.finish(result);
  return result;
}

}  // namespace insonate
