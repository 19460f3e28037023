#include <insonate/cases/VesselName.h>
#include <insonate/core/Words.h>
#include <insonate/simulator/ProcedureFit.h>

#include <algorithm>
#include <array>

namespace insonate {
namespace {

bool isTargetOf(const Procedure& procedure, const Target& target) {
  return !procedure.target.empty() && namesVessel(target.name, procedure.target);
}

/// The built-in procedure for a case's target.
std::optional<Procedure> procedureFor(const CaseManifest& manifest) {
  for (const std::string& name : procedurePresetNames()) {
    auto preset = builtInProcedure(name);
    if (preset && std::ranges::any_of(manifest.targets, [&](const Target& one) { return isTargetOf(*preset, one); }))
      return std::move(*preset);
  }
  return std::nullopt;
}

}  // namespace

Result<void> checkProcedureFits(const Procedure& procedure, const CaseManifest& manifest,
                                std::span<const std::uint8_t> labels) {
  const std::string what = "'" + procedure.title + "' does not fit the case '" + manifest.title + "': ";
  for (const NeededStructure& need : procedure.needs)
    if (std::ranges::find(labels, need.label) == labels.end())
      return fail(what + "nothing is labeled " + std::string(labelTable()[need.label].name) + ", so " + need.why +
                  ". Label it, or open another case.");
  if (hasLine(procedure) &&
      std::ranges::find(manifest.vessels, std::uint8_t{kVein}, &NamedVessel::label) == manifest.vessels.end())
    return fail(what +
                "the wire follows the course of named vessels, and the case names no vein. Name the vein in "
                "Prepare, or open another case.");
  if (procedure.target.empty() ||
      std::ranges::any_of(manifest.targets, [&](const Target& one) { return isTargetOf(procedure, one); }))
    return {};
  const auto other = procedureFor(manifest);
  if (!other) return {};
  std::vector<std::string_view> names;
  for (const Target& target : manifest.targets) names.push_back(target.name);
  return fail(what + "the case is for " + quotedWords(names) + ". Choose '" + other->title +
              "', or open a case that has the " + procedure.target + " vein as its target.");
}

Result<void> checkProcedureFits(const Procedure& procedure, const PatientCase& patient) {
  std::array<bool, 256> has{};
  for (const std::uint8_t label : patient.labels.voxels) has[label] = true;
  std::vector<std::uint8_t> labels;
  for (std::size_t label = 0; label < has.size(); ++label)
    if (has[label]) labels.push_back(static_cast<std::uint8_t>(label));
  return checkProcedureFits(procedure, patient.manifest, labels);
}

}  // namespace insonate
