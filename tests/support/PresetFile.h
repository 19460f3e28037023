#pragma once

#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <set>
#include <string>

namespace insonate::test {

/// A preset under resources/ as it was written.
inline nlohmann::json presetFile(const std::string& folder, const std::string& name) {
  std::ifstream stream(std::string(INSONATE_SOURCE_DIR "/resources/") + folder + "/" + name + ".json");
  return nlohmann::json::parse(stream);
}

inline double numberOf(const nlohmann::json& value) {
  return value == "infinity" ? std::numeric_limits<double>::infinity() : value.get<double>();
}

/// Checks that every number of a preset lies in its range and cites one of the file's sources, and that none is listed
/// in vain.
class SourceCheck {
 public:
  explicit SourceCheck(const nlohmann::json& file) : sources_(file.at("sources")) {}

  /// `where` is told on failure.
  void number(const nlohmann::json& number, const std::string& where) {
    ++numbers_;
    ASSERT_TRUE(number.is_object()) << where << " is a plain number";
    ASSERT_TRUE(number.contains("range")) << where;
    EXPECT_LE(numberOf(number["range"][0]), numberOf(number["value"])) << where;
    EXPECT_GE(numberOf(number["range"][1]), numberOf(number["value"])) << where;
    const std::string source = number.at("source").get<std::string>();
    const std::string citation = source.substr(0, source.find(':'));
    EXPECT_TRUE(sources_.contains(citation)) << where << " cites '" << citation << "'";
    cited_ += source + '\n';
  }
  void finish(int minNumbers) const {
    EXPECT_GE(numbers_, minNumbers);
    for (const auto& [name, source] : sources_.items()) EXPECT_NE(cited_.find(name), std::string::npos) << name;
  }

 private:
  const nlohmann::json sources_;
  std::string cited_;
  int numbers_ = 0;
};

/// The labels that a preset lists, each by a name that is known, and once.
inline std::set<std::string> labelsListed(const nlohmann::json& file) {
  std::set<std::string> labels;
  for (const nlohmann::json& tissue : file.at("tissues")) {
    const auto name = tissue.at("label").get<std::string>();
    EXPECT_TRUE(labelFromName(name)) << name;
    EXPECT_TRUE(labels.insert(name).second) << name;
  }
  return labels;
}

}  // namespace insonate::test
