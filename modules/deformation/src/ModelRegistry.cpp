#include "Models.h"

#include <insonate/core/Range.h>
#include <insonate/core/Words.h>
#include <insonate/deformation/DeformationModel.h>

namespace insonate {
namespace {

struct KnownModel {
  std::string_view name;
  std::unique_ptr<DeformationModel> (*make)(const MechanicalTable&, const DeformationSettings&);
};

/// The default is first.
const std::vector<KnownModel>& knownModels() {
  static const std::vector<KnownModel> models{
      {"elastic", makeElasticModel},
      {"column", makeColumnModel},
      {"reference", makeReferenceModel},
  };
  return models;
}

Result<void> checkSettings(const DeformationSettings& settings) {
  if (auto ok = checkRange(settings.mesh_mm, 0.1, 4, "Deformation: mesh_mm"); !ok) return ok;
  if (auto ok = checkRange(settings.depth_mm, 10, 200, "Deformation: depth_mm"); !ok) return ok;
  if (auto ok = checkRange(settings.maxIterations, 1, 1000, "Deformation: maxIterations"); !ok) return ok;
  return checkRange(settings.tolerance_mm, 0, 1, "Deformation: tolerance_mm");
}

Error unknownModel(std::string_view name) {
  std::vector<std::string_view> names;
  for (const KnownModel& model : knownModels()) names.push_back(model.name);
  const std::string_view near = nearestWord(name, names);
  std::string sentence = "There is no deformation model '" + std::string(name) + "' (" + joinedWords(names) + ")";
  return {near.empty() ? sentence + "." : sentence + "; did you mean '" + std::string(near) + "'?"};
}

}  // namespace

std::vector<std::string> deformationModelNames() {
  std::vector<std::string> names;
  for (const KnownModel& model : knownModels()) names.emplace_back(model.name);
  return names;
}

Result<std::unique_ptr<DeformationModel>> makeDeformationModel(std::string_view name, const MechanicalTable& tissues,
                                                               const DeformationSettings& settings) {
  if (auto ok = checkSettings(settings); !ok) return tl::unexpected(ok.error());
  for (const KnownModel& model : knownModels())
    if (model.name == name) return model.make(tissues, settings);
  return tl::unexpected(unknownModel(name));
}

}  // namespace insonate
