#include <insonate/ui/FormSheet.h>

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest/QTest>

namespace {

using namespace insonate;

Form form() {
  Form made;
  made.name = "small", made.title = "Small form";
  FormItem scale{"scale", "How <b>real</b> & true?", "Look at all of it.", FormItem::Kind::Choice, true, {}, 0, 0};
  for (const char* one : {"1", "2", "3"}) scale.options.push_back({one, std::string("Option ") + one, std::nullopt});
  made.sections.push_back({"First", "What it is about.", {scale}});
  made.sections.push_back({"Second",
                           "",
                           {{"years", "Years", "", FormItem::Kind::Number, false, {}, 0, 60},
                            {"words", "Words", "", FormItem::Kind::Text, false, {}, 0, 0}}});
  return made;
}

class FormSheet : public testing::Test {
 protected:
  void SetUp() override {
    sheet.resize(700, 500);
    sheet.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&sheet));
    QApplication::setActiveWindow(&sheet);
  }
  template <class T>
  T* child(const char* name) {
    T* found = sheet.findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  std::string error(const char* name) { return child<QLabel>(name)->text().toStdString(); }

  ui::FormSheet sheet{form()};
};

TEST_F(FormSheet, ArrowKeysChooseTheFirstAnswerToo) {
  child<QRadioButton>("form_scale_1")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
  EXPECT_TRUE(child<QRadioButton>("form_scale_1")->isChecked()) << "nothing was chosen yet";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
  EXPECT_TRUE(child<QRadioButton>("form_scale_2")->isChecked());
}

TEST_F(FormSheet, LongAnswersWrapInsteadOfBeingCut) {
  Form longer = form();
  longer.sections[0].items[0].options[0].title =
      "Uses strong force, jabs, or moves the needle sideways under the skin, again and again";
  ui::FormSheet narrow(longer);
  narrow.resize(260, 600);
  narrow.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&narrow));
  const auto* answer = narrow.findChild<QRadioButton*>("form_scale_1");
  EXPECT_TRUE(answer->text().contains('\n'));
  EXPECT_LE(answer->sizeHint().width(), narrow.width());
  EXPECT_GE(answer->height(), answer->sizeHint().height());
  narrow.resize(1200, 600);
  QTest::qWait(0);
  EXPECT_FALSE(answer->text().contains('\n'));
}

TEST_F(FormSheet, IsFilledInByTheKeyboardAlone) {
  QSignalSpy changed(&sheet, &ui::FormSheet::changed);
  child<QRadioButton>("form_scale_1")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
  EXPECT_TRUE(child<QRadioButton>("form_scale_2")->isChecked());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "form_years");
  QTest::keyClicks(QApplication::focusWidget(), "12.5");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "form_words");
  QTest::keyClicks(QApplication::focusWidget(), "good");
  EXPECT_EQ(sheet.answers(), (FormAnswers{{"scale", "2"}, {"years", 12.5}, {"words", "good"}}));
  EXPECT_GT(changed.count(), 3);
  EXPECT_TRUE(sheet.check());

  child<QRadioButton>("form_scale_2")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Delete);
  EXPECT_FALSE(sheet.answers().contains("scale")) << "taken back";
}

TEST_F(FormSheet, TabGoesToTheSelectedAnswerWhichSpaceKeeps) {
  sheet.setAnswers({{"scale", "3"}});
  child<QLineEdit>("form_years")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "form_scale_3");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(sheet.answers(), (FormAnswers{{"scale", "3"}}));
  child<QRadioButton>("form_scale_2")->click();
  child<QLineEdit>("form_years")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "form_scale_2");
}

TEST_F(FormSheet, SaysBesideTheQuestionWhatIsWrong) {
  child<QLineEdit>("form_years")->setText("many");
  EXPECT_FALSE(sheet.check());
  EXPECT_NE(error("trouble_scale").find("needs an answer"), std::string::npos) << error("trouble_scale");
  EXPECT_NE(error("trouble_years").find("from 0 to 60"), std::string::npos) << error("trouble_years");
  EXPECT_FALSE(child<QLabel>("trouble_words")->isVisible());
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "form_scale_1") << "the first one that is wrong";
  child<QRadioButton>("form_scale_3")->click();
  EXPECT_FALSE(child<QLabel>("trouble_scale")->isVisible()) << "it is being put right";
  child<QLineEdit>("form_years")->setText("61");
  EXPECT_FALSE(sheet.check());
  child<QLineEdit>("form_years")->setText("60");
  EXPECT_TRUE(sheet.check());
}

TEST_F(FormSheet, TakesBackWhatItGave) {
  const FormAnswers answers{{"scale", "3"}, {"years", 0.1}, {"words", "two\nlines"}};
  QSignalSpy changed(&sheet, &ui::FormSheet::changed);
  sheet.setAnswers(answers);
  EXPECT_EQ(sheet.answers(), answers);
  EXPECT_EQ(changed.count(), 0);
  sheet.setAnswers({{"scale", "7"}, {"scale", 2.0}, {"unknown", "x"}});
  EXPECT_TRUE(sheet.answers().empty()) << "an option that is not there, a question that is not asked";
}

TEST_F(FormSheet, AnswersStandBelowEachOtherWhereThereIsNoRoom) {
  const auto top = [&](const char* name) { return child<QRadioButton>(name)->y(); };
  EXPECT_EQ(top("form_scale_1"), top("form_scale_3"));
  sheet.resize(120, 500);
  QApplication::processEvents();
  EXPECT_LT(top("form_scale_1"), top("form_scale_3"));
}

TEST(FormNotes, StandBesideTheItemsOfAChecklist) {
  Form checklist = form();
  checklist.purpose = Form::Purpose::Checklist;
  ui::FormSheet sheet(checklist);
  sheet.resize(700, 500);
  sheet.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&sheet));
  QApplication::setActiveWindow(&sheet);
  auto* button = sheet.findChild<QToolButton*>("noteButton_scale");
  auto* note = sheet.findChild<QLineEdit*>("note_scale");
  ASSERT_TRUE(button && note);
  EXPECT_FALSE(sheet.findChild<QToolButton*>("noteButton_words")) << "a text needs none";
  EXPECT_FALSE(note->isVisible());
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_TRUE(note->hasFocus());
  QTest::keyClicks(note, "  at 0:42, <b>& %1  ");
  EXPECT_EQ(sheet.answers(), (FormAnswers{{"scale:note", "at 0:42, <b>& %1"}}));
  button->click();
  EXPECT_TRUE(note->isVisible()) << "what is written is not hidden";

  const FormAnswers kept{{"scale", "2"}, {"scale:note", "kept"}};
  sheet.setAnswers(kept);
  EXPECT_EQ(sheet.answers(), kept);
  EXPECT_TRUE(note->isVisible());
  note->setText(QString(10'001, 'x'));
  EXPECT_FALSE(sheet.check());
  EXPECT_TRUE(sheet.findChild<QLabel*>("trouble_scale")->text().contains("too long"));
  sheet.setAnswers({});
  EXPECT_FALSE(note->isVisible());
}

}  // namespace
