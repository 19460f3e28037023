#include "StepFile.h"

#include "StepWriter.h"

namespace insonate::segmentation {
namespace {

using nlohmann::json;

/// Fields that every step may have in addition to its tool's fields.
template <class Io>
void commonFields(Io& io, LabelStep& s) {
  io("label", s.label);
  io("rest", s.rest);
  io("locked", s.locked);
  io("over", s.over);
  io("editable_HU", s.editable_HU);
  io("box_mm", s.box_mm);
  io("of", s.of);
}

/// The names of a step's fields.
struct FieldNames {
  std::vector<std::string_view> names{"tool", "comment"};
  template <class... Rest>
  void operator()(const char* key, Rest&&...) {
    names.emplace_back(key);
  }
};

template <std::size_t... N>
LabelTool toolOf(std::size_t index, std::index_sequence<N...>) {
  LabelTool tool;
  ((index == N ? void(tool.emplace<N>()) : void()), ...);
  return tool;
}

/// Tools that need no label, since they write several labels or those that the CT gives.
bool needsLabel(const LabelTool& tool) {
  return !std::holds_alternative<step::Auto>(tool) && !std::holds_alternative<step::SmoothTogether>(tool) &&
         !std::holds_alternative<step::GrowSeeds>(tool) && !std::holds_alternative<step::Watershed>(tool);
}

}  // namespace

LabelStep readStep(const json& object, const std::string& where, std::string& error, Points points) {
  LabelStep step;
  // The known fields depend on the tool, which is read first.
  JsonEntry entry(object, where, jsonKeys(object), error);
  step.tool = toolOf(entry.word("tool", {kToolNames.begin(), kToolNames.end()}),
                     std::make_index_sequence<std::variant_size_v<LabelTool>>());
  if (!error.empty()) return step;
  const std::string tool = where + " (" + std::string(nameOf(step.tool)) + ")";
  FieldNames known;
  commonFields(known, step);
  std::visit([&](auto& parameters) { fields(known, parameters); }, step.tool);
  StepReader reader(object, tool, known.names, points, error);
  commonFields(reader, step);
  std::visit([&](auto& parameters) { fields(reader, parameters); }, step.tool);
  if (needsLabel(step.tool) && !object.contains("label")) reader.setError("has no 'label': name the one it is for.");
  return step;
}

json jsonOf(LabelStep step) {
  json object{{"tool", nameOf(step.tool)}};
  StepWriter writer(object);
  commonFields(writer, step);
  std::visit([&](auto& parameters) { fields(writer, parameters); }, step.tool);
  if (!needsLabel(step.tool)) object.erase("label");
  return object;
}

}  // namespace insonate::segmentation
