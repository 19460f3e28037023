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

/// Parses JSON; fails with line and column of the error. `what` is the subject of the error sentence, e.g. "The
/// recipe".
Result<nlohmann::json> parsedJson(std::string_view text, const std::string& what);

/// Returns the keys of an object, for an entry that accepts any key; empty if `object` is another kind of value.
std::vector<std::string_view> keysOf(const nlohmann::json& object);

/// Reader of an object in a JSON file that people write. Each field is read by its own call. The first error is kept as
/// a sentence; fields that are read after an error are empty. `where` begins the sentence: "step 'scan'". Keys other
/// than the `known` ones are errors. The object must outlive the reader.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known)
      : JsonEntry(object, std::move(where), known, ownTrouble_) {}
  /// Makes a reader that stores the first error in `trouble`, which the entries of one file share.
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known,
            std::string& trouble);
  JsonEntry(const JsonEntry&) = delete;
  JsonEntry& operator=(const JsonEntry&) = delete;

  /// Returns a text. A needed text is there and not empty.
  std::string text(std::string_view key, bool needed = true);
  double number(std::string_view key, double low, double high);
  std::optional<double> numberIfThere(std::string_view key, double low, double high);
  /// Reads an optional number, written either as a number or as an object with "value", "range" [low, high] and
  /// "source". With `orInfinity`, the word "infinity" is also accepted.
  std::optional<double> sourcedIfThere(std::string_view key, double low, double high, bool orInfinity = false);
  /// Returns the whole number under the key, which must be there and lie within low to high.
  int whole(std::string_view key, int low, int high);
  std::optional<int> wholeIfThere(std::string_view key, int low, int high);
  /// Returns `count` numbers; zeros after an error. `order` describes the list in the error sentence: "[x, y, z]".
  std::vector<double> numbers(std::string_view key, std::size_t count, double low, double high,
                              std::string_view order = {});
  bool flag(std::string_view key);
  /// Returns the index, within `words`, of the word under the key.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words);
  std::vector<std::string> texts(std::string_view key);
  /// Returns the value under the key, which must be there; an empty object after an error.
  const nlohmann::json& value(std::string_view key);

  /// Reads the entries of a list with `read(entry, where, trouble)`; stops at the first entry that sets `trouble`. A
  /// missing list is empty. `where` is `noun` followed by the entry's name or number. Two entries with the same "name"
  /// are an error, unless `namesDiffer` is false.
  template <class Read>
  auto list(std::string_view key, const std::string& noun, const Read& read, bool namesDiffer = true) {
    std::vector<std::invoke_result_t<Read, const nlohmann::json&, const std::string&, std::string&>> all;
    each(
        key, noun,
        [&](const nlohmann::json& entry, const std::string& where, std::string& trouble) {
          all.push_back(read(entry, where, trouble));
        },
        namesDiffer);
    return all;
  }

  using Reader = std::function<void(const nlohmann::json& entry, const std::string& where, std::string& trouble)>;
  /// Reads the entries of a list as list() does; `read` keeps what it reads.
  void each(std::string_view key, const std::string& noun, const Reader& read, bool namesDiffer = true);

  bool has(std::string_view key) const;
  void refuse(const std::string& sentence);
  const std::string& where() const { return where_; }
  /// Returns the first error; empty if there is none.
  const std::string& trouble() const { return trouble_; }

 private:
  const nlohmann::json* find(std::string_view key, bool needed);
  const nlohmann::json& array(std::string_view key);
  std::optional<double> boundedNumber(std::string_view key, double low, double high, bool orInfinity);
  void checkStatedRange(double value);

  const nlohmann::json& object_;
  std::string where_, ownTrouble_;
  std::string& trouble_;
};

}  // namespace insonate
