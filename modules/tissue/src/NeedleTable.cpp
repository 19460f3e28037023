#include "TableFile.h"

#include <insonate/embedded/needles.h>
#include <insonate/tissue/NeedleTable.h>

#include <algorithm>

namespace insonate {
namespace {

using nlohmann::json;
using tissuefile::Field;
using Tissue = NeedleTissue;

constexpr std::array kNumbers{
    Field<Tissue>{"stiffness_Npmm", &Tissue::stiffness_Npmm, 0, 50},
    Field<Tissue>{"stiffening_Npmm2", &Tissue::stiffening_Npmm2, 0, 10},
    Field<Tissue>{"puncture_N", &Tissue::puncture_N, 0, 20},
    Field<Tissue>{"cutting_N", &Tissue::cutting_N, 0, 10},
    Field<Tissue>{"cuttingStiffness_Npmm", &Tissue::cuttingStiffness_Npmm, 0, 10},
    Field<Tissue>{"friction_Npmm", &Tissue::friction_Npmm, 0, 1},
    Field<Tissue>{"stiction_Npmm", &Tissue::stiction_Npmm, 0, 1},
    Field<Tissue>{"viscosity_Nspmm2", &Tissue::viscosity_Nspmm2, 0, 0.01},
    Field<Tissue>{"lateral_Npmm2", &Tissue::lateral_Npmm2, 0, 1},
};

/// In the order of NeedleWall.
constexpr std::array<std::string_view, 3> kWalls{"none", "membrane", "hard"};
/// Words of the field "probe", the behavior of the transducer at this structure; the second one is true.
constexpr std::array<std::string_view, 2> kProbe{"passes", "touches"};

template <std::size_t N>
Result<int> readWord(const json& entry, const char* key, const std::array<std::string_view, N>& words, int before,
                     bool complete, const std::string& where) {
  const auto found = entry.find(key);
  const std::string all = joinedWords({words.begin(), words.end()});
  if (found == entry.end()) {
    if (complete) return fail(where + ": " + key + " is missing; it is one of " + all + ".");
    return before;
  }
  const auto choice =
      found->is_string() ? std::find(words.begin(), words.end(), found->get<std::string>()) : words.end();
  if (choice == words.end())
    return fail(where + ": " + key + " must be one of " + all + ", not " + tissuefile::shown(*found) + ".");
  return static_cast<int>(choice - words.begin());
}

/// Contradictory values would make the servo return more energy than it received.
Result<void> checkTogether(const Tissue& t, const std::string& where) {
  if (t.stiction_Npmm < t.friction_Npmm)
    return fail(where + ": stiction_Npmm is " + tissuefile::shown(t.stiction_Npmm) + ", below friction_Npmm " +
                tissuefile::shown(t.friction_Npmm) + "; what sticks holds at least as well as what slides.");
  if (t.wall == NeedleWall::None) return {};
  if (t.stiffness_Npmm <= 0 && t.stiffening_Npmm2 <= 0)
    return fail(where + ": a wall needs stiffness_Npmm or stiffening_Npmm2 above 0.");
  if (t.wall == NeedleWall::Membrane && t.puncture_N <= 0)
    return fail(where + ": a membrane needs puncture_N above 0.");
  return {};
}

Result<void> readNeedle(const json& entry, bool complete, const std::string& where, Tissue& tissue) {
  if (auto ok = tissuefile::checkKeys(entry, tissuefile::namesOf(kNumbers, {"label", "wall", "probe"}), where); !ok)
    return ok;
  const auto wall = readWord(entry, "wall", kWalls, static_cast<int>(tissue.wall), complete, where);
  if (!wall) return tl::unexpected(wall.error());
  const auto probe = readWord(entry, "probe", kProbe, tissue.probeTouches ? 1 : 0, complete, where);
  if (!probe) return tl::unexpected(probe.error());
  tissue.wall = static_cast<NeedleWall>(*wall);
  tissue.probeTouches = *probe == 1;
  if (auto ok = tissuefile::readNumbers(entry, kNumbers, complete, where, tissue); !ok) return ok;
  return checkTogether(tissue, where);
}

const tissuefile::TableForm<NeedleTable>& needleForm() {
  static const tissuefile::TableForm<NeedleTable> all{"needle", presetsOf(embedded::needles::files()), readNeedle};
  return all;
}

}  // namespace

std::vector<std::string> needlePresetNames() {
  const auto names = needleForm().names();
  return {names.begin(), names.end()};
}

Result<NeedleTable> parseNeedleTable(std::string_view text) {
  return tissuefile::parseTable(text, needleForm());
}

Result<NeedleTable> loadNeedleTable(std::string_view nameOrPath) {
  return tissuefile::loadTable(nameOrPath, needleForm());
}

}  // namespace insonate
