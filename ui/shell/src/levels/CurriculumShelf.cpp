#include "CurriculumShelf.h"

#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <algorithm>

namespace insonate::ui {
namespace {

using Kind = OfferedCurriculum::Kind;

Result<void> keep(const SignedIn& by, const Curriculum& draft) {
  return PublishedCurricula(by).saveDraft(draft.name, curriculumText(draft), "");
}

}  // namespace

Result<std::vector<OfferedCurriculum>> taughtCurricula(const SignedIn& by) {
  const auto published = PublishedCurricula(by).list();
  if (!published) return tl::unexpected(published.error());
  std::vector<OfferedCurriculum> offered;
  for (const CurriculumEntry& entry : *published) offered.push_back({entry.name, entry.version, Kind::Published});
  for (const std::string& name : curriculumPresetNames()) {
    const auto preset = loadCurriculum(name);
    const auto isIt = [&](const auto& one) { return one.name == name && one.version == preset->version; };
    if (preset && std::ranges::none_of(offered, isIt)) offered.push_back({name, preset->version, Kind::Preset});
  }
  return offered;
}

Result<std::vector<OfferedCurriculum>> allCurricula(const SignedIn& by) {
  const auto drafts = PublishedCurricula(by).drafts();
  if (!drafts) return tl::unexpected(drafts.error());
  auto taught = taughtCurricula(by);
  if (!taught) return taught;
  std::vector<OfferedCurriculum> all;
  for (const std::string& name : *drafts) all.push_back({name, 0, Kind::Draft});
  all.insert(all.end(), taught->begin(), taught->end());
  return all;
}

Result<std::string> textOf(const SignedIn& by, const OfferedCurriculum& offered) {
  if (offered.kind == Kind::Draft) return PublishedCurricula(by).draft(offered.name);
  if (offered.kind == Kind::Published) return PublishedCurricula(by).text(offered.name, offered.version);
  const auto preset = loadCurriculum(offered.name);
  if (!preset) return tl::unexpected(preset.error());
  return curriculumText(*preset);
}

Result<void> teachBy(const SignedIn& by, const OfferedCurriculum& taught, const std::string& cohort) {
  if (taught.kind == Kind::Preset) {
    const auto text = textOf(by, taught);
    if (!text) return tl::unexpected(text.error());
    const auto published = PublishedCurricula(by).publish(taught.name, taught.version, *text);
    if (!published) return tl::unexpected(published.error());
  }
  return CohortStore(by).setCurriculum(cohort, taught.name, taught.version);
}

Result<KeptDraft> draftFrom(const SignedIn& by, const OfferedCurriculum& taught) {
  const PublishedCurricula published(by);
  const auto drafts = published.drafts();
  if (!drafts) return tl::unexpected(drafts.error());
  if (std::ranges::find(*drafts, taught.name) == drafts->end()) {
    const auto text = textOf(by, taught);
    if (!text) return tl::unexpected(text.error());
    auto curriculum = parseDraft(*text);
    if (!curriculum) return tl::unexpected(curriculum.error());
    const auto list = published.list();
    if (!list) return tl::unexpected(list.error());
    for (const CurriculumEntry& entry : *list)
      if (entry.name == taught.name) curriculum->version = std::max(curriculum->version, entry.version);
    ++curriculum->version;
    if (const auto kept = keep(by, *curriculum); !kept) return tl::unexpected(kept.error());
  }
  const auto text = published.draft(taught.name);
  if (!text) return tl::unexpected(text.error());
  return KeptDraft{taught.name, *text};
}

Result<KeptDraft> newDraft(const SignedIn& by, const std::string& name) {
  const auto all = allCurricula(by);
  if (!all) return tl::unexpected(all.error());
  if (std::ranges::find(*all, name, &OfferedCurriculum::name) != all->end())
    return fail("There is already a curriculum named '" + name +
                "'; choose another name, or begin a new version of that curriculum.");
  Curriculum draft{.name = name};
  draft.levels.push_back({.name = "level_1", .procedure = "internal_jugular"});
  const std::string text = curriculumText(draft);
  if (const auto read = parseDraft(text); !read) return tl::unexpected(read.error());
  if (const auto kept = keep(by, draft); !kept) return tl::unexpected(kept.error());
  return KeptDraft{name, text};
}

Result<void> publishDraft(const SignedIn& by, const Curriculum& draft, const std::string& before) {
  const PublishedCurricula curricula(by);
  const std::string text = curriculumText(draft);
  if (const auto saved = curricula.saveDraft(draft.name, text, before); !saved) return saved;
  if (const auto published = curricula.publish(draft.name, draft.version, text); !published)
    return tl::unexpected(published.error());
  return curricula.discardDraft(draft.name, text);
}

}  // namespace insonate::ui
