#include "store/CurriculumRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PublishedCurricula.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;

constexpr std::size_t kMaxText = 1'000'000;

Result<void> checkPublishable(const std::string& name, int version, const std::string& text) {
  if (auto ok = store::checkTitle("The curriculum's name", name); !ok) return ok;
  if (name.empty()) return fail("The curriculum has no name; give it one.");
  if (version < 1) return fail("The curriculum's version is " + std::to_string(version) + "; versions count from 1.");
  if (auto ok = store::checkText("The curriculum", text, kMaxText); !ok) return ok;
  const auto curriculum = parseCurriculum(text);
  if (!curriculum) return tl::unexpected(curriculum.error());
  if (curriculum->name == name && curriculum->version == version) return {};
  return fail("The text is version " + std::to_string(curriculum->version) + " of '" + curriculum->name +
              "', not version " + std::to_string(version) + " of '" + name +
              "'; publish it under its own name and version.");
}

Result<CurriculumEntry> publishText(Transaction& transaction, const CurriculumEntry& entry, const std::string& text) {
  if (const auto kept = store::findCurriculum(transaction, entry.name, entry.version)) {
    if (kept->entry.hash == entry.hash) return kept->entry;
    return fail("Version " + std::to_string(entry.version) + " of '" + entry.name +
                "' is already published and cannot be changed. Publish this text as a later version.");
  }
  const auto newest = transaction.number("SELECT MAX(version) FROM curricula WHERE name = ?", entry.name);
  if (entry.version < newest)
    return fail("Version " + std::to_string(newest) + " of '" + entry.name +
                "' is published already; publish this text as a later version.");
  store::insertCurriculum(transaction, {entry, text});
  return entry;
}

Result<void> checkDraft(const std::string& name, const std::string& text) {
  if (auto ok = store::checkTitle("The draft's name", name); !ok) return ok;
  if (name.empty()) return fail("The draft has no name; give it one.");
  return store::checkText("The draft", text, kMaxText);
}

/// Checks that the draft has not changed since the caller read it.
Result<void> checkUntouched(Transaction& transaction, const std::string& name, const std::string& before) {
  const auto row = transaction.row("SELECT text FROM drafts WHERE name = ?", name);
  if ((row ? row->text(0) : "") == before) return {};
  if (!row) return fail("Another user has discarded or published the draft '" + name + "' since you read it.");
  return fail("Another user has saved the draft '" + name +
              "' since you read it; reload it, or save under another name.");
}

tl::unexpected<Error> noDraft(const std::string& name) {
  return fail("There is no draft named '" + name + "'; reload the list.");
}

}  // namespace

Result<std::vector<CurriculumEntry>> PublishedCurricula::list() const {
  return by_.session()->read({.act = Act::ReadCurricula},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<CurriculumEntry>> {
                               return store::listCurricula(transaction);
                             });
}

Result<std::string> PublishedCurricula::text(const std::string& name, int version) const {
  return by_.session()->read({.act = Act::ReadCurricula}, [&](Transaction& transaction, const Actor&) {
    return store::publishedText(transaction, name, version);
  });
}

Result<CurriculumEntry> PublishedCurricula::publish(const std::string& name, int version,
                                                    const std::string& text) const {
  if (auto ok = checkPublishable(name, version, text); !ok) return tl::unexpected(ok.error());
  const Core& core = by_.session()->core();
  const Person& by = by_.person();
  const CurriculumEntry entry{name, version, store::sha256(text), core.now_us(),
                              by.fullName.empty() ? by.name : by.fullName};
  return by_.session()->write(
      {.act = Act::Publish, .detail = name + " " + std::to_string(version)},
      [&](Transaction& transaction, const Actor&) { return publishText(transaction, entry, text); });
}

Result<void> PublishedCurricula::saveDraft(const std::string& name, const std::string& text,
                                           const std::string& before) const {
  if (auto ok = checkDraft(name, text); !ok) return ok;
  return by_.session()->write(
      {.act = Act::WriteDrafts, .detail = "save " + name}, [&](Transaction& transaction, const Actor&) -> Result<void> {
        if (auto ok = checkUntouched(transaction, name, before); !ok) return ok;
        transaction.run("INSERT INTO drafts VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET text = excluded.text", name,
                        text);
        return {};
      });
}

Result<std::vector<std::string>> PublishedCurricula::drafts() const {
  return by_.session()->read({.act = Act::SeeDrafts},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<std::string>> {
                               std::vector<std::string> names;
                               for (const Row& row : transaction.rows("SELECT name FROM drafts ORDER BY name"))
                                 names.push_back(row.text(0));
                               return names;
                             });
}

Result<std::string> PublishedCurricula::draft(const std::string& name) const {
  return by_.session()->read({.act = Act::SeeDrafts},
                             [&](Transaction& transaction, const Actor&) -> Result<std::string> {
                               const auto row = transaction.row("SELECT text FROM drafts WHERE name = ?", name);
                               if (!row) return noDraft(name);
                               return row->text(0);
                             });
}

Result<void> PublishedCurricula::discardDraft(const std::string& name, const std::string& before) const {
  return by_.session()->write({.act = Act::WriteDrafts, .detail = "discard " + name},
                              [&](Transaction& transaction, const Actor&) -> Result<void> {
                                if (before.empty()) return noDraft(name);
                                if (auto ok = checkUntouched(transaction, name, before); !ok) return ok;
                                transaction.run("DELETE FROM drafts WHERE name = ?", name);
                                return {};
                              });
}

}  // namespace insonate
