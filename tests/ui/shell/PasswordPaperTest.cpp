#include "account/PasswordPaper.h"

#include <gtest/gtest.h>
#include <ui/support/PlainTexts.h>

#include <QFile>
#include <QLineEdit>
#include <QPrintDialog>
#include <QPrinter>
#include <QPrinterInfo>
#include <QTemporaryDir>
#include <QTextDocument>
#include <QTimer>

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
  EXPECT_TRUE(text.contains("Sign-in name") && text.contains("First password"));
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

/// Without a printer the dialog writes a file, whose name stands in its only line of text.
void answerPrintDialog(QWidget& window, const QString& file) {
  auto* looking = new QTimer(&window);
  QObject::connect(looking, &QTimer::timeout, &window, [looking, &window, file] {
    auto* dialog = window.findChild<QPrintDialog*>();
    if (!dialog || !dialog->isVisible()) return;
    looking->deleteLater();
    if (file.isEmpty()) return dialog->reject();
    dialog->printer()->setOutputFileName(file);
    for (auto* line : dialog->findChildren<QLineEdit*>())
      if (line->objectName() == "filename") line->setText(file);
    dialog->accept();
  });
  looking->start(20);
}

TEST(PasswordPaper, GoesWhereTheDialogOfPrintersSays) {
  if (!QPrinterInfo::availablePrinterNames().isEmpty()) GTEST_SKIP() << "there is a printer, which would print";
  const QTemporaryDir home;
  QWidget window;
  window.show();
  const std::vector<FirstPassword> passwords{{{}, "first password"}};
  const QString file = home.filePath("paper.pdf");
  answerPrintDialog(window, file);
  const auto printed = ui::printPasswordPaper("Autumn", passwords, &window);
  ASSERT_TRUE(printed) << printed.error().message;
  EXPECT_TRUE(printed->startsWith("Saved as " + file)) << printed->toStdString();
  QFile pdf(file);
  ASSERT_TRUE(pdf.open(QFile::ReadOnly));
  EXPECT_TRUE(pdf.read(4) == "%PDF");
  EXPECT_EQ(pdf.permissions() & (QFile::ReadGroup | QFile::ReadOther), 0) << "it holds passwords";

  answerPrintDialog(window, {});
  EXPECT_EQ(ui::printPasswordPaper("Autumn", passwords, &window).value_or("x"), QString()) << "thought better of it";
}

}  // namespace
