#include "FormAnswersFile.h"

#include <insonate/core/Preset.h>
#include <insonate/curriculum/Csv.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <vector>

namespace insonate::cli {
namespace {

constexpr const char* kHead = "The first line must name the columns: item,answer or item,answer,note.";

/// Text that is no number stays text; checkAnswers() reports it.
FormAnswers::mapped_type answerOf(const FormItem* item, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const bool isNumber = item && item->kind == FormItem::Kind::Number &&
                        std::from_chars(text.data(), end, value) == std::from_chars_result{end, std::errc()};
  return isNumber ? FormAnswers::mapped_type(value) : FormAnswers::mapped_type(text);
}

Result<void> addRow(const Form& form, const CsvRow& row, std::size_t columns, FormAnswers& answers) {
  const std::string where = "Line " + std::to_string(row.line) + ": ";
  if (row.fields.size() > columns)
    return fail(where + "there are more fields than columns. Put fields that contain commas into quotes.");
  const auto field = [&](std::size_t at) { return at < row.fields.size() ? row.fields[at] : std::string(); };
  const FormItem* item = form.item(field(0));
  if (!item) return fail(where + "'" + field(0) + "' is not an item of '" + form.title + "'; leave it out.");
  if (answers.contains(item->name) || answers.contains(noteKey(*item)))
    return fail(where + "'" + item->name + "' is answered twice. Leave one answer.");
  if (!field(1).empty()) answers.emplace(item->name, answerOf(item, field(1)));
  if (!field(2).empty()) answers.emplace(noteKey(*item), field(2));
  return {};
}

Result<FormAnswers> parseTable(const Form& form, const std::string& text) {
  const auto rows = parseCsv(text);
  if (!rows) return tl::unexpected(rows.error());
  const std::vector<std::string> columns{"item", "answer", "note"};
  if (rows->empty()) return fail(kHead);
  const auto& head = rows->front().fields;
  if (head.size() < 2 || head.size() > columns.size() || !std::equal(head.begin(), head.end(), columns.begin()))
    return fail(kHead);
  FormAnswers answers;
  for (auto row = rows->begin() + 1; row != rows->end(); ++row)
    if (auto added = addRow(form, *row, head.size(), answers); !added) return tl::unexpected(added.error());
  return answers;
}

}  // namespace

Result<FormAnswers> answersFromFile(const Form& form, const std::string& file) {
  const auto text = presetOrFile("a JSON object of answers, or a .csv file", file, {});
  if (!text) return tl::unexpected(text.error());
  auto answers =
      std::filesystem::path(file).extension() == ".csv" ? parseTable(form, text->text) : parseAnswers(text->text);
  if (!answers) return fail(text->where + answers.error().message);
  const auto errors = checkAnswers(form, *answers);
  if (errors.empty()) return answers;
  std::string sentence = file + " does not fill in '" + form.name + "':";
  for (const AnswerError& error : errors) sentence += " " + error.item + ": " + error.sentence;
  return fail(sentence);
}

}  // namespace insonate::cli
