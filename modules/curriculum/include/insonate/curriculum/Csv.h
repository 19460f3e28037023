#pragma once

#include <insonate/core/Result.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// One row of a CSV file.
struct CsvRow {
  int line = 1;  ///< line of the file on which the row begins
  std::vector<std::string> fields{};
};

/// Parses CSV (RFC 4180): quoted fields may contain separators, line breaks and doubled quotes. Also accepted are a
/// byte order mark, any kind of line end, and semicolons or tabs as separators. If the first line is like "sep=;", it
/// states the separator and is not returned. Otherwise, the separator is the character that is most frequent in the
/// first line outside quotes. Empty lines are left out. Fails, with the line, if a quote is not closed, if text follows
/// a closing quote, or if the text is not UTF-8 or contains NUL.
Result<std::vector<CsvRow>> parseCsv(std::string_view text);

/// Writes rows as CSV (RFC 4180, CRLF). The text begins with a byte order mark: without the mark Excel does not read
/// UTF-8; LibreOffice, Moodle and parseCsv() ignore the mark. If a field begins with =, +, -, @ or a line break, a
/// spreadsheet would interpret the field as a formula. Such a field gets an apostrophe in front, unless the field is a
/// number. The same is done after each semicolon or tab within a field, since spreadsheets may separate fields there.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

/// Writes a number as the shortest text that parses to the same value; "" for a missing or non-finite value.
std::string csvNumber(std::optional<double> value);

}  // namespace insonate
