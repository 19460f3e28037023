#include "MechanicalFields.h"

#include <insonate/core/Words.h>

#include <algorithm>

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

constexpr std::array<Field<Tissue>, 0> kNoFields{};

/// In the order of Mechanics.
constexpr std::array<std::string_view, 4> kKinds{"solid", "rigid", "lumen", "gas"};

Result<Mechanics> readKind(const json& entry, bool needed, const std::string& where, Mechanics before) {
  const std::vector<std::string_view> kinds{kKinds.begin(), kKinds.end()};
  const auto found = entry.find("kind");
  if (found == entry.end()) {
    if (needed) return fail(where + ": kind is missing; it is one of " + joinedWords(kinds) + ".");
    return before;
  }
  const auto choice =
      found->is_string() ? std::find(kKinds.begin(), kKinds.end(), found->get<std::string>()) : kKinds.end();
  if (choice == kKinds.end())
    return fail(where + ": kind must be one of " + joinedWords(kinds) + ", not " + shown(*found) + ".");
  return static_cast<Mechanics>(choice - kKinds.begin());
}

/// A field that belongs to another kind has its own error sentence, different from that of a misspelled field.
template <std::size_t N>
Result<void> readFields(const json& entry, const std::array<Field<Tissue>, N>& fields, bool complete,
                        const std::string& where, Tissue& tissue) {
  const auto known = namesOf(fields, {"label", "kind"});
  const auto all = namesOf(kSolidFields, namesOf(kLumenFields, {}));
  for (const auto& [key, value] : entry.items())
    if (std::find(known.begin(), known.end(), key) == known.end() &&
        std::find(all.begin(), all.end(), key) != all.end())
      return fail(where + ": " + key + " says nothing of a tissue of kind " +
                  std::string(kKinds[static_cast<int>(tissue.kind)]) + "; remove it, or change the kind.");
  if (auto ok = checkKeys(entry, known, where); !ok) return ok;
  return readNumbers(entry, fields, complete, where, tissue);
}

}  // namespace

Result<void> readMechanics(const json& entry, bool complete, const std::string& where, MechanicalTissue& tissue) {
  const auto kind = readKind(entry, complete, where, tissue.kind);
  if (!kind) return tl::unexpected(kind.error());
  if (complete || *kind != tissue.kind) {
    tissue = {};
    tissue.kind = *kind;
    complete = true;
  }
  switch (tissue.kind) {
    case Mechanics::Solid:
      return readFields(entry, kSolidFields, complete, where, tissue);
    case Mechanics::Lumen:
      return readFields(entry, kLumenFields, complete, where, tissue);
    case Mechanics::Rigid:
    case Mechanics::Gas:
      return readFields(entry, kNoFields, complete, where, tissue);
  }
  return {};
}

json written(const MechanicalTissue& tissue) {
  json entry{{"kind", kKinds[static_cast<std::size_t>(tissue.kind)]}};
  if (tissue.kind == Mechanics::Solid) writeNumbers(tissue, kSolidFields, entry);
  if (tissue.kind == Mechanics::Lumen) writeNumbers(tissue, kLumenFields, entry);
  return entry;
}

}  // namespace insonate::tissuefile
