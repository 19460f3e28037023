#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace insonate {

/// Reader of an object in a JSON file that people write; fields are taken one by one. The first error is kept as a
/// sentence; fields after it are empty. `where` begins the sentence: "step 'scan'". The object must outlive the
/// reader.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known);

  std::string text(const char* key, bool needed = true);
  double number(const char* key, double low, double high);
  std::optional<double> numberIfThere(const char* key, double low, double high);
  /// Returns a whole number.
  int whole(const char* key, int low, int high);
  std::optional<int> wholeIfThere(const char* key, int low, int high);
  bool flag(const char* key);
  /// The index, among these words, of the word under the key.
  std::size_t word(const char* key, const std::vector<std::string_view>& words);
  std::vector<std::string> texts(const char* key);
  const nlohmann::json& object(const char* key);

  /// Reads the entries of a list with `read(entry, where, trouble)` until one leaves a trouble; a missing list is
  /// empty. `noun` and an entry's name or number make its `where`. Entries with a "name" need different ones.
  template <class Read>
  auto list(const char* key, const std::string& noun, const Read& read) {
    std::vector<std::invoke_result_t<Read, const nlohmann::json&, const std::string&, std::string&>> all;
    each(key, noun, [&](const nlohmann::json& entry, const std::string& where, std::string& trouble) {
      all.push_back(read(entry, where, trouble));
    });
    return all;
  }

  bool has(const char* key) const;
  void refuse(const std::string& sentence);
  const std::string& where() const { return where_; }
  /// "" while all is well.
  const std::string& trouble() const { return trouble_; }

 private:
  using Reader = std::function<void(const nlohmann::json& entry, const std::string& where, std::string& trouble)>;

  const nlohmann::json* find(const char* key, bool needed);
  const nlohmann::json& array(const char* key);
  void each(const char* key, const std::string& noun, const Reader& read);

  const nlohmann::json& object_;
  std::string where_, trouble_;
};

}  // namespace insonate
