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

/// Parses CSV (RFC 4180): quoted fields may contain separators, line breaks and doubled quotes. Also accepted: a byte
/// order mark, any line end, and semicolons or tabs instead of commas (the separator that is most frequent in the first
/// line, outside quotes; or the one that a first line "sep=;" names, which is no row). Empty lines are left out. Fails,
/// with the line, if a quote is not closed, if text follows a closing quote, or if the text is not UTF-8 or contains
/// NUL.
Result<std::vector<CsvRow>> parseCsv(std::string_view text);

/// Writes rows as CSV (RFC 4180, CRLF). The text begins with a byte order mark: without the mark Excel does not read
/// UTF-8; LibreOffice, Moodle and parseCsv() remove it. A field that a spreadsheet would take for a formula (because it
/// begins with =, +, -, @ or a line break) gets an apostrophe before it, unless the field is a number. The same is done
/// after each semicolon or tab within a field, since spreadsheets may separate fields there.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

/// Writes a number as the shortest text that parses to the same value; "" for a missing or non-finite value.
std::string csvNumber(std::optional<double> value);

}  // namespace insonate
