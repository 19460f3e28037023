#include "store/Texts.h"

#include <insonate/curriculum/Csv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace insonate {
namespace {

constexpr std::size_t kMaxBytes = 64U << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

char separatorOf(std::string_view text) {
  constexpr std::string_view kSeparators = ",;\t";
  std::array<int, kSeparators.size()> counts{};
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\n' || c == '\r')) break;
    const auto found = kSeparators.find(c);
    if (!quoted && found != std::string_view::npos) ++counts[found];
  }
  return kSeparators[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
}

/// Length of a first line "sep=;" without its line end; 0 if the text does not begin with one. Excel writes and reads
/// this line, which names the separator.
std::size_t separatorLine(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const bool isQuoted = line.size() == 7 && line.front() == '"' && line.back() == '"';
  const std::string_view words = isQuoted ? line.substr(1, 5) : line;
  const bool isNamed = words.size() == 5 && (words.starts_with("sep=") || words.starts_with("SEP="));
  return isNamed && std::string_view(",;\t").find(words[4]) != std::string_view::npos ? line.size() : 0;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text), separator_(separatorOf(text)) {
    const std::size_t named = separatorLine(text);
    if (named == 0) return;
    separator_ = text[text.find('=') + 1];
    at_ = named;
    skipLineEnd();
  }

  Result<std::vector<CsvRow>> rows() {
    std::vector<CsvRow> rows;
    while (at_ < text_.size()) {
      CsvRow row{line_, {}};
      do
        if (auto field = readField())
          row.fields.push_back(std::move(*field));
        else
          return tl::unexpected(field.error());
      while (skipSeparator());
      skipLineEnd();
      if (row.fields.size() > 1 || !row.fields.front().empty()) rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  bool isLineEnd() const { return text_[at_] == '\n' || text_[at_] == '\r'; }

  Result<std::string> readField() {
    if (at_ < text_.size() && text_[at_] == '"') return readQuoted();
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != separator_ && !isLineEnd()) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  Result<std::string> readQuoted() {
    const int begunAt = line_;
    std::string field;
    bool closed = false;
    for (++at_; at_ < text_.size() && !closed; ++at_) {
      closed = text_[at_] == '"' && !text_.substr(at_ + 1).starts_with('"');
      if (closed) continue;
      field += text_[at_];
      at_ += text_[at_] == '"';
    }
    if (!closed) return fail("Line " + std::to_string(begunAt) + " opens a quote that is never closed.");
    const auto breaks = std::ranges::count(field, '\n');
    line_ += static_cast<int>(breaks > 0 ? breaks : std::ranges::count(field, '\r'));
    if (at_ < text_.size() && text_[at_] != separator_ && !isLineEnd())
      return fail("Line " + std::to_string(line_) +
                  " has text after a closing quote; double the quotes that belong to the text.");
    return field;
  }

  bool skipSeparator() {
    if (at_ >= text_.size() || text_[at_] != separator_) return false;
    ++at_;
    return true;
  }

  void skipLineEnd() {
    if (at_ >= text_.size()) return;
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
    ++at_, ++line_;
  }

  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
  int line_ = 1;
};

bool isNumber(const std::string& field) {
  double value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(value);
}

/// Tells whether a spreadsheet would evaluate this text as a formula. Some programs accept the full-width forms of the
/// signs.
bool beginsFormula(std::string_view text) {
  return std::ranges::any_of(std::array{"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"},
                             [&](const char* sign) { return text.starts_with(sign); });
}

/// A spreadsheet that expects another separator (semicolons in much of Europe) does not recognize the quotes and splits
/// the field.
std::string defused(std::string_view field) {
  constexpr std::string_view kBlanks = "\t\r\n", kBreaks = ";\t\r\n";
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool begins = i == 0 || kBreaks.find(field[i - 1]) != std::string_view::npos;
    if ((begins && beginsFormula(field.substr(i))) || (i == 0 && kBlanks.find(field[0]) != std::string_view::npos))
      text += '\'';
    text += field[i];
  }
  return text;
}

std::string written(const std::string& field) {
  constexpr std::string_view kQuoted = ",;\t\"\r\n";
  const std::string text = isNumber(field) ? field : defused(field);
  if (text.find_first_of(kQuoted) == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace

Result<std::vector<CsvRow>> parseCsv(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return fail("The file is UTF-16, as some spreadsheets save Unicode; save it as \"CSV UTF-8\".");
  if (auto fine = store::checkText("The file", text, kMaxBytes); !fine) return tl::unexpected(fine.error());
  return Reader(text).rows();
}

std::string csvText(const std::vector<std::vector<std::string>>& rows) {
  std::string text(kByteOrderMark);
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i ? "," : "") + written(row[i]);
    text += "\r\n";
  }
  return text;
}

std::string csvNumber(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return {};
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), *value);
  return {digits.data(), end};
}

}  // namespace insonate
