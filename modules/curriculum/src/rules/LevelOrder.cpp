#include "LevelOrder.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace insonate {
namespace {

using Indices = std::map<std::string_view, std::size_t>;

Result<void> checkPrerequisites(const std::vector<Level>& levels, const Indices& indices) {
  std::vector<std::string_view> names;
  for (const Level& level : levels) names.push_back(level.name);
  for (const Level& level : levels) {
    std::set<std::string_view> seen;
    for (const std::string& needed : level.prerequisites) {
      const std::string where = "level '" + level.name + "' has the ";
      if (!seen.insert(needed).second) return fail(where + "prerequisite '" + needed + "' twice.");
      if (indices.contains(needed)) continue;
      const std::string_view near = nearestWord(needed, names);
      return fail(where + "unknown prerequisite '" + needed + "'" +
                  (near.empty() ? "; it is one of " + joinedWords(names) + "."
                                : "; did you mean '" + std::string(near) + "'?"));
    }
  }
  return {};
}

/// Sentence about a cycle, "'a' needs 'b', 'b' needs 'a'", from any of the remaining levels, each of which needs
/// another of them.
std::string circleAmong(const std::vector<Level>& levels, const Indices& indices, const std::vector<bool>& done) {
  std::vector<std::size_t> way;
  std::size_t at = static_cast<std::size_t>(std::ranges::find(done, false) - done.begin());
  while (std::ranges::find(way, at) == way.end()) {
    way.push_back(at);
    for (const std::string& needed : levels[at].prerequisites)
      if (!done[indices.at(needed)]) {
        at = indices.at(needed);
        break;
      }
  }
  way.erase(way.begin(), std::ranges::find(way, at));
  way.push_back(at);
  std::string text;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    text += (i ? ", '" : "'") + levels[way[i]].name + "' needs '" + levels[way[i + 1]].name + "'";
  return text;
}

}  // namespace

Result<std::vector<Level>> inOrderOfLearning(std::vector<Level> levels) {
  Indices indices;
  for (std::size_t i = 0; i < levels.size(); ++i) indices.emplace(levels[i].name, i);
  if (auto fine = checkPrerequisites(levels, indices); !fine) return tl::unexpected(fine.error());
  std::vector<bool> done(levels.size(), false);
  std::vector<std::size_t> order;
  const auto ready = [&](std::size_t i) {
    return !done[i] && std::ranges::all_of(levels[i].prerequisites,
                                           [&](const std::string& needed) { return done[indices.at(needed)]; });
  };
  while (order.size() < levels.size()) {
    std::size_t next = 0;
    while (next < levels.size() && !ready(next)) ++next;
    if (next == levels.size())
      return fail("the prerequisites of the levels form a circle: " + circleAmong(levels, indices, done) +
                  "; remove one of these prerequisites.");
    done[next] = true;
    order.push_back(next);
  }
  std::vector<Level> ordered;
  for (const std::size_t i : order) ordered.push_back(std::move(levels[i]));
  return ordered;
}

}  // namespace insonate
