#include "NumberFields.h"
#include "TableFile.h"

#include <insonate/embedded/mechanics.h>
#include <insonate/tissue/MechanicalTable.h>
#include <insonate/tissue/TableText.h>

#include <algorithm>
#include <string>

namespace insonate::tissuefile {
namespace {

using nlohmann::json;
using Tissue = MechanicalTissue;

constexpr double kSoftest_kPa = 0.01, kStiffest_kPa = 1e8;

constexpr std::array kSolidFields{
    Field<Tissue>{"young_kPa", &Tissue::young_kPa, kSoftest_kPa, kStiffest_kPa, true},
    Field<Tissue>{"poisson", &Tissue::poisson, 0, 0.499},
};

constexpr std::array kLumenFields{
    Field<Tissue>{"poisson", &Tissue::poisson, 0, 0.499},
    Field<Tissue>{"wall_mm", &Tissue::wall_mm, 0, 5},
    Field<Tissue>{"wallYoung_kPa", &Tissue::wallYoung_kPa, kSoftest_kPa, kStiffest_kPa},
    Field<Tissue>{"sheath_mm", &Tissue::sheath_mm, 0, 10},
    Field<Tissue>{"sheathYoung_kPa", &Tissue::sheathYoung_kPa, kSoftest_kPa, kStiffest_kPa},
    Field<Tissue>{"pressure_kPa", &Tissue::pressure_kPa, -5, 50},
};

/// In the order of Mechanics.
constexpr std::array<std::string_view, 4> kKinds{"solid", "rigid", "lumen", "gas"};

/// A field that exists, but not for this kind, deserves another sentence than a misspelt one.
void refuseFieldsOfOtherKinds(JsonEntry& entry, Mechanics kind) {
  std::vector<std::string_view> own;
  if (kind == Mechanics::Solid) own = presetNames(kSolidFields, {});
  if (kind == Mechanics::Lumen) own = presetNames(kLumenFields, {});
  for (const std::string_view name : presetNames(kLumenFields, presetNames(kSolidFields, {})))
    if (entry.has(name) && std::ranges::find(own, name) == own.end())
      entry.setError("has '" + std::string(name) + "', which does not apply to a tissue of kind " +
                     std::string(kKinds[static_cast<std::size_t>(kind)]) + "; remove it, or change the kind.");
}

/// Fills `tissue` from an entry of "tissues". Every number of its kind has to be there with `complete`, and where the
/// entry makes it another kind; else the missing ones stay as they are. A number of another kind is refused.
void readMechanics(const json& object, bool complete, const std::string& where, std::string& error,
                   MechanicalTissue& tissue) {
  JsonEntry entry(object, where, presetNames(kLumenFields, {"label", "kind", "young_kPa"}), error);
  const auto kind = complete || entry.has("kind")
                        ? static_cast<Mechanics>(entry.word("kind", {kKinds.begin(), kKinds.end()}))
                        : tissue.kind;
  if (complete || kind != tissue.kind) {
    tissue = {};
    tissue.kind = kind;
    complete = true;
  }
  refuseFieldsOfOtherKinds(entry, kind);
  if (kind == Mechanics::Solid) readNumbers(entry, kSolidFields, complete, tissue);
  if (kind == Mechanics::Lumen) readNumbers(entry, kLumenFields, complete, tissue);
}

/// Inverse of readMechanics(), complete.
json written(const MechanicalTissue& tissue) {
  json entry{{"kind", kKinds[static_cast<std::size_t>(tissue.kind)]}};
  if (tissue.kind == Mechanics::Solid) writeNumbers(tissue, kSolidFields, entry);
  if (tissue.kind == Mechanics::Lumen) writeNumbers(tissue, kLumenFields, entry);
  return entry;
}

}  // namespace
}  // namespace insonate::tissuefile

namespace insonate {
namespace {

const tissuefile::TableForm<MechanicalTable>& mechanicalForm() {
  static const tissuefile::TableForm<MechanicalTable> all{"mechanics", embeddedPresets(embedded::mechanics::files()),
                                                          tissuefile::readMechanics};
  return all;
}

}  // namespace

std::vector<std::string> mechanicalPresetNames() {
  return presetNames(mechanicalForm().presets);
}

Result<MechanicalTable> parseMechanicalTable(std::string_view text) {
  return tissuefile::parseTable(text, mechanicalForm());
}

Result<MechanicalTable> loadMechanicalTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, mechanicalForm());
}

std::string textOf(const MechanicalTable& table) {
  return tissuefile::tableText(table, tissuefile::written);
}

}  // namespace insonate
