#include "support/TestData.h"

#include <insonate/curriculum/ClassList.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Form.h>

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace insonate {
namespace {

/// One to four bytes changed, taken out or put in.
std::string damaged(std::string text, std::mt19937& random) {
  for (auto n = 1 + random() % 4; n > 0 && !text.empty(); --n) {
    const std::size_t at = random() % text.size();
    const char byte = "{}[],:\"\\0-e.n \n\xFF"[random() % 16];
    if (random() % 3 == 0)
      text.erase(at, 1 + random() % 8);
    else if (random() % 2)
      text.insert(at, 1, byte);
    else
      text[at] = byte;
  }
  return text;
}

std::string presetText(const std::string& name) {
  return test::bytesOf(std::string(INSONATE_SOURCE_DIR "/resources/") + name + ".json");
}

/// Calls `read`, which says what is wrong or "", with damaged texts: each is read or refused in a sentence.
template <class Read>
void expectSentences(const std::string& text, int runs, const Read& read) {
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < runs; ++i) {
    const std::string error = read(damaged(text, random));
    if (error.empty()) continue;
    ++refused;
    EXPECT_TRUE(error.ends_with(".") || error.ends_with("?")) << error;
  }
  EXPECT_GT(refused, 0);
}

TEST(DamagedFiles, ACurriculumIsReadOrRefused) {
  expectSentences(presetText("curricula/central_line"), 1500, [](const std::string& text) {
    const auto curriculum = parseCurriculum(text);
    if (!curriculum) return curriculum.error().message;
    const auto again = parseCurriculum(curriculumText(*curriculum));
    EXPECT_TRUE(again && *again == *curriculum);
    return std::string();
  });
}

TEST(DamagedFiles, AFormIsReadOrRefused) {
  for (const std::string& name : formPresetNames())
    expectSentences(presetText("forms/" + name), 500, [](const std::string& text) {
      const auto form = parseForm(text);
      if (form) formScore(*form, {});
      return form ? "" : form.error().message;
    });
}

TEST(DamagedFiles, AClassListIsReadOrRefused) {
  const std::string list =
      "First name;Last name;ID number;Email address\r\nAda;\"Love;lace\";M-1;a@x.org\r\n\"B \"\"b\"\"\";C;;c@x.org\r\n";
  expectSentences(list, 20'000, [](const std::string& text) {
    const auto people = parseClassList(text);
    if (people) matchClassList(*people, {});
    return people ? "" : people.error().message;
  });
}

}  // namespace
}  // namespace insonate
