#include "account/PasswordPaper.h"

#include <gtest/gtest.h>
#include <ui/support/PlainTexts.h>

#include <QFile>
#include <QPrinter>
#include <QTemporaryDir>
#include <QTextDocument>

namespace {

using namespace insonate;

TEST(PasswordPaper, HasAStripForEachWithNamesAsTheyAre) {
  const QTemporaryDir home;
  std::vector<FirstPassword> passwords(60);
  for (std::size_t i = 0; i < passwords.size(); ++i) {
    passwords[i].person.fullName = test::kHostileText.toStdString();
    passwords[i].password = "first password " + std::to_string(i);
  }
  QTextDocument paper;
  ui::fillPasswordPaper(paper, test::kHostileText, passwords);
  const QString text = paper.toPlainText();
  EXPECT_EQ(text.count(test::kHostileMark), 61) << "the class and each of the people";
  for (const FirstPassword& one : passwords) EXPECT_TRUE(text.contains(QString::fromStdString(one.password)));

  QPrinter printer;
  printer.setOutputFormat(QPrinter::PdfFormat);
  printer.setOutputFileName(home.filePath("passwords.pdf"));
  paper.print(&printer);
  QFile pdf(printer.outputFileName());
  ASSERT_TRUE(pdf.open(QFile::ReadOnly));
  const QByteArray bytes = pdf.readAll();
  EXPECT_TRUE(bytes.startsWith("%PDF"));
  EXPECT_GT(bytes.count("/Type /Page\n"), 1) << "60 strips go on to another page";
}

}  // namespace
