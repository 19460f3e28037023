#pragma once

#include <insonate/core/Result.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::procedurefile {

/// An object of a procedure file, whose fields are taken one by one. The first thing that is wrong is kept as a
/// sentence; what is asked after that is empty. `where` opens the sentence: "step 'scan'".
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& object, std::string where, const std::vector<std::string_view>& known);

  std::string text(const char* key, bool needed = true);
  double number(const char* key, double low, double high);
  std::optional<double> numberIfThere(const char* key, double low, double high);
  bool flag(const char* key);
  /// The index of one of these words.
  std::size_t word(const char* key, const std::vector<std::string_view>& words);
  /// A list of objects; empty where it is missing.
  const nlohmann::json& list(const char* key);
  const nlohmann::json& object(const char* key);

  bool has(const char* key) const { return object_.is_object() && object_.contains(key); }
  void refuse(const std::string& sentence);
  const std::string& where() const { return where_; }
  /// "" while all is well.
  const std::string& trouble() const { return trouble_; }

 private:
  const nlohmann::json* find(const char* key, bool needed);

  const nlohmann::json& object_;
  std::string where_, trouble_;
};

}  // namespace insonate::procedurefile
