#include "SlicerSegmentation.h"

#include "LabelNames.h"
#include "NrrdWriter.h"

#include <insonate/tissue/Labels.h>

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
  bool known = true;
};

std::string colourText(const LabelColour& colour) {
  std::string text;
  for (int c = 0; c < 3; ++c) text += (c ? " " : "") + exactDecimal(colour[c] / 255.0);
  return text;
}

/// Three shares of 0 to 1; none where the text is something else.
std::optional<LabelColour> colourFromText(const std::string& text) {
  LabelColour colour{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::uint8_t& part : colour) {
    while (at < end && *at == ' ') ++at;
    double share = 0;
    const auto [rest, error] = std::from_chars(at, end, share);
    if (error != std::errc() || !(share >= 0 && share <= 1)) return std::nullopt;
    part = static_cast<std::uint8_t>(std::lround(share * 255));
    at = rest;
  }
  return colour;
}

/// Several segments may be one structure: the first one's colour counts.
LabelColours coloursOf(const std::vector<Segment>& segments, const std::map<std::string, std::string>& metadata) {
  LabelColours all;
  for (std::size_t n = 0; n < segments.size(); ++n) {
    const auto found = metadata.find("Segment" + std::to_string(n) + "_Color");
    const auto colour = found == metadata.end() ? std::nullopt : colourFromText(found->second);
    if (colour && segments[n].known) all.try_emplace(segments[n].label, *colour);
  }
  std::erase_if(all, [](const auto& one) { return one.second == colourOf({}, one.first); });
  return all;
}

std::string tagsOfLabel(int label) {
  std::string tags = "Segmentation.Status:completed|";
  if (label < kLabelCount && !labelTable()[label].snomedCode.empty())
    tags +=
        "TerminologyEntry:Segmentation category and type - 3D Slicer General Anatomy list"
        "~SCT^85756007^Tissue~SCT^" +
        std::string(labelTable()[label].snomedCode) + "^" + std::string(labelTable()[label].snomedMeaning) +
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

/// A file of several layers that names none of them has a layer for each segment, in their order.
std::vector<Segment> segmentsOf(const RawVolume& raw, std::vector<std::string>& notes) {
  const auto& metadata = raw.metadata;
  std::vector<Segment> segments;
  for (int n = 0; metadata.contains("Segment" + std::to_string(n) + "_ID"); ++n) {
    const std::string key = "Segment" + std::to_string(n) + "_";
    const auto text = [&](const char* field) {
      const auto found = metadata.find(key + field);
      return found == metadata.end() ? std::string{} : found->second;
    };
    Segment s{text("Name"), static_cast<int>(integerOf(metadata, key + "Layer", raw.components > 1 ? n : 0)),
              integerOf(metadata, key + "LabelValue", 1), 0};
    auto label = labelFromSnomed(typeCodeOf(text("Tags")));
    if (!label) label = labelFromAnyName(s.name);
    s.label = label.value_or(kSoftTissue);
    s.known = label.has_value();
    const std::string what = "The segment \"" + s.name + "\" (number " + std::to_string(s.value) + ")";
    if (!label) {
      notes.push_back(what +
                      " is no structure this program knows and is read as soft tissue; rename it to change that.");
    } else if (s.label != s.value) {
      notes.push_back(what + " is read as " + labelName(s.label) + " (" + std::to_string(s.label) + ").");
    }
    segments.push_back(s);
  }
  return segments;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> slicerFields(const LabelMap& labels, const LabelColours& colours) {
  std::array<bool, 256> used{};
  for (const std::uint8_t v : labels.voxels) used[v] = true;
  // The whole grid as every segment's extent: segments that share a layer must share it.
  std::string extent;
  for (int n : labels.geometry.size) extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(n - 1);

  std::vector<std::pair<std::string, std::string>> fields;
  int segment = 0;
  for (int label = 1; label < 256; ++label) {
    if (!used[label]) continue;
    const std::string key = "Segment" + std::to_string(segment++) + "_";
    fields.insert(fields.end(), {{key + "ID", "Segment_" + std::to_string(label)},
                                 {key + "Name", labelName(label)},
                                 {key + "NameAutoGenerated", "0"},
                                 {key + "Color", colourText(colourOf(colours, static_cast<std::uint8_t>(label)))},
                                 {key + "ColorAutoGenerated", "0"},
                                 {key + "Extent", extent},
                                 {key + "Layer", "0"},
                                 {key + "LabelValue", std::to_string(label)},
                                 {key + "Tags", tagsOfLabel(label)}});
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

Result<LabelReadResult> fromSlicerSegmentation(const RawVolume& raw, const VolumeGeometry& geometry) {
  LabelReadResult result{LabelMap(geometry), {}};
  const std::vector<Segment> segments = segmentsOf(raw, result.notes);
  result.colours = coloursOf(segments, raw.metadata);
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
      overlap = overlap || (last && last->label != found->second->label);
      if (!last || found->second > last) last = found->second;
    }
    overlaps += overlap;
    if (last) result.labels.voxels[v] = last->label;
  }
  for (const auto& [layer, value] : orphans)
    result.notes.push_back("The number " + std::to_string(value) + " belongs to no segment and was ignored.");
  if (overlaps > 0)
    result.notes.push_back(std::to_string(overlaps) + " voxels belong to several segments; the last one wins.");
  return result;
}

}  // namespace insonate
