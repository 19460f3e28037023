#include "store/CurriculumRows.h"

#include "store/Texts.h"

namespace insonate::store {
namespace {

CurriculumEntry entryOf(const Row& row) {
  return {row.text(0), row.count(1), row.text(2), row.number(3), row.text(4)};
}

}  // namespace

std::vector<CurriculumEntry> listCurricula(Transaction& transaction) {
  std::vector<CurriculumEntry> entries;
  for (const Row& row : transaction.rows(
           "SELECT name, version, hash, published_us, published_by FROM curricula ORDER BY name, version DESC"))
    entries.push_back(entryOf(row));
  return entries;
}

std::optional<StoredCurriculum> findCurriculum(Transaction& transaction, const std::string& name, int version) {
  const auto row = transaction.row(
      "SELECT name, version, hash, published_us, published_by, text FROM curricula WHERE name = ? AND version = ?",
      name, version);
  return row ? std::optional(StoredCurriculum{entryOf(*row), row->text(5)}) : std::nullopt;
}

void insertCurriculum(Transaction& transaction, const StoredCurriculum& curriculum) {
  const CurriculumEntry& entry = curriculum.entry;
  transaction.run("INSERT INTO curricula VALUES (?, ?, ?, ?, ?, ?)", entry.name, entry.version, curriculum.text,
                  entry.hash, entry.published_us, entry.publishedBy);
}

Result<void> checkHash(const StoredCurriculum& curriculum) {
  if (sha256(curriculum.text) == curriculum.entry.hash) return {};
  return fail(
      "The text of version " + std::to_string(curriculum.entry.version) + " of '" + curriculum.entry.name +
      "' is not the one that was published. Another program has written to the database. Compare it with a backup.");
}

Result<std::string> publishedText(Transaction& transaction, const std::string& name, int version) {
  const auto kept = findCurriculum(transaction, name, version);
  if (!kept) return fail("Version " + std::to_string(version) + " of the curriculum '" + name + "' is not published.");
  if (auto ok = checkHash(*kept); !ok) return tl::unexpected(ok.error());
  return kept->text;
}

Result<Curriculum> publishedCurriculum(Transaction& transaction, const std::string& name, int version) {
  const auto text = publishedText(transaction, name, version);
  if (!text) return tl::unexpected(text.error());
  return parseCurriculum(*text);
}

}  // namespace insonate::store
