#include "PasswordPaper.h"

#include <insonate/ui/Text.h>

#include <QFile>
#include <QPrintDialog>
#include <QPrinter>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

namespace insonate::ui {
namespace {

/// Restricts the file to its owner before anything is written into it.
bool beginsPrivate(const QString& name) {
  QFile file(name);
  return file.open(QFile::WriteOnly) && file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
}

}  // namespace

void fillPasswordPaper(QTextDocument& paper, const QString& cohort, const std::vector<FirstPassword>& passwords) {
  constexpr double kLine_pt = 1, kPadding_pt = 6;
  QTextCursor cursor(&paper);
  cursor.insertText(tr("First passwords, %1. Each person chooses a new password at the first sign-in.").arg(cohort));
  QTextTableFormat format;
  format.setBorder(kLine_pt);
  format.setBorderStyle(QTextFrameFormat::BorderStyle_Dashed);
  format.setBorderCollapse(true);
  format.setHeaderRowCount(1);  // repeated on each page
  format.setCellPadding(kPadding_pt);
  format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
  QTextTable* table = cursor.insertTable(int(passwords.size()) + 1, 3, format);
  const QString titles[] = {tr("Full name"), tr("Sign-in name"), tr("First password")};
  for (int column = 0; column < 3; ++column) table->cellAt(0, column).firstCursorPosition().insertText(titles[column]);
  for (int row = 0; row < int(passwords.size()); ++row) {
    const auto& [person, password] = passwords[std::size_t(row)];
    const QString texts[] = {qt(person.fullName), qt(person.name), qt(password)};
    for (int column = 0; column < 3; ++column)
      table->cellAt(row + 1, column).firstCursorPosition().insertText(texts[column]);
  }
}

Result<QString> printPasswordPaper(const QString& cohort, const std::vector<FirstPassword>& passwords,
                                   QWidget* parent) {
  QPrinter printer(QPrinter::HighResolution);
  printer.setDocName(tr("First passwords"));
  QPrintDialog dialog(&printer, parent);
  if (dialog.exec() != QDialog::Accepted) return QString();
  const QString file = printer.outputFileName();
  if (!file.isEmpty() && !beginsPrivate(file))
    return fail(tr("%1 cannot be written; choose another folder, or save the passwords.").arg(file).toStdString());
  QTextDocument paper;
  fillPasswordPaper(paper, cohort, passwords);
  paper.print(&printer);
  if (printer.printerState() == QPrinter::Error)
    return fail(tr("The printer did not accept the page; try another printer, or save the passwords.").toStdString());
  return file.isEmpty() ? tr("Sent to the printer. Cut the page into slips and hand them out.")
                        : tr("Saved as %1, which only you can read. Delete the file after printing.").arg(file);
}

}  // namespace insonate::ui
