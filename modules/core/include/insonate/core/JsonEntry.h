#pragma once

#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace insonate {

/// Parses JSON. Fails with a sentence that states the line and column of the error. `what` is the subject of that
/// sentence, e.g. "The recipe".
Result<nlohmann::json> parsedJson(std::string_view text, const std::string& what);

/// Returns the keys of `object`; empty if `object` is not a JSON object. Pass them as `known` to a JsonEntry that
/// accepts any key.
std::vector<std::string_view> jsonKeys(const nlohmann::json& object);

/// Reads the fields of one object in a JSON file that people write; each call reads one field. The reader keeps the
/// first error as a sentence. After an error, all further calls return empty values or zeros. `where` names the object
/// at the beginning of the sentence, e.g. "step 'scan'". A key that is not in `known` is an error. The object must
/// outlive the reader.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known)
      : JsonEntry(object, std::move(where), known, ownError_) {}
  /// Makes a reader that stores the first error in `error`, which the entries of one file share.
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known,
            std::string& error);
  JsonEntry(const JsonEntry&) = delete;
  JsonEntry& operator=(const JsonEntry&) = delete;

  /// Returns the text under the key. If `needed`, a missing or empty text is an error; otherwise a missing text is
  /// returned as "".
  std::string text(std::string_view key, bool needed = true);
  /// Returns the number under the key. A missing key, or a number below `low` or above `high`, is an error.
  double number(std::string_view key, double low, double high);
  /// Returns an optional number; no value if the key is missing. A number below `low` or above `high` is an error.
  std::optional<double> optionalNumber(std::string_view key, double low, double high);
  /// Returns an optional number, as optionalNumber() does. In the file, the value is a number, or an object with
  /// "value", "range" [low, high] and "source". With `allowInfinity`, the word "infinity" is also accepted.
  std::optional<double> optionalNumberWithSource(std::string_view key, double low, double high,
                                                 bool allowInfinity = false);
  /// Returns the whole number under the key. A missing key, a fraction, or a number below `low` or above `high` is an
  /// error.
  int integer(std::string_view key, int low, int high);
  /// Returns an optional whole number; no value if the key is missing.
  std::optional<int> optionalInteger(std::string_view key, int low, int high);
  /// Returns the list of `count` numbers under the key, each within low to high; zeros after an error. `order`
  /// describes the list in the error sentence, e.g. "[x, y, z]".
  std::vector<double> numbers(std::string_view key, std::size_t count, double low, double high,
                              std::string_view order = {});
  /// Returns an optional true or false; false if the key is missing.
  bool flag(std::string_view key);
  /// Returns the position in `words` of the word under the key. A missing word, or a word that is not in `words`, is an
  /// error.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words);
  std::vector<std::string> texts(std::string_view key);
  /// Returns the value under the key, of any type. A missing key is an error; then an empty object is returned.
  const nlohmann::json& value(std::string_view key);

  /// Reads the entries of a list with `read(entry, where, error)`, and returns the values that `read` returns. Stops at
  /// the first entry for which `read` sets `error`. A missing list is empty. `where` is `noun` followed by the entry's
  /// name or number. Two entries with the same "name" are an error, unless `namesDiffer` is false.
  template <class Read>
  auto list(std::string_view key, const std::string& noun, const Read& read, bool namesDiffer = true) {
    std::vector<std::invoke_result_t<Read, const nlohmann::json&, const std::string&, std::string&>> all;
    forEach(
        key, noun,
        [&](const nlohmann::json& entry, const std::string& where, std::string& error) {
          all.push_back(read(entry, where, error));
        },
        namesDiffer);
    return all;
  }

  using Reader = std::function<void(const nlohmann::json& entry, const std::string& where, std::string& error)>;
  /// Reads the entries of a list as list() does, but returns nothing: `read` stores the values itself.
  void forEach(std::string_view key, const std::string& noun, const Reader& read, bool namesDiffer = true);

  /// Tells whether the object has the key.
  bool has(std::string_view key) const;
  /// Records an error that the caller has found: where() followed by `sentence`. Ignored if an earlier error is
  /// recorded.
  void setError(const std::string& sentence);
  const std::string& where() const { return where_; }
  /// Returns the first error; empty if there is none.
  const std::string& error() const { return error_; }

 private:
  const nlohmann::json* find(std::string_view key, bool needed);
  const nlohmann::json& array(std::string_view key);
  std::optional<double> boundedNumber(std::string_view key, double low, double high, bool allowInfinity);
  void checkStatedRange(double value);

  const nlohmann::json& object_;
  std::string where_, ownError_;
  std::string& error_;
};

}  // namespace insonate
