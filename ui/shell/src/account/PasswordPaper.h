#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FirstPassword.h>

#include <QString>
#include <vector>

class QTextDocument;
class QWidget;

namespace insonate::ui {

/// Fills a page with a name and password for each person, to be cut into strips. Names are inserted as plain text.
void fillPasswordPaper(QTextDocument& paper, const QString& cohort, const std::vector<FirstPassword>& passwords);

/// Lets the user choose a printer, and prints the page on the printer or to a file that only its owner can read.
/// Returns a sentence that says where the page was printed; "" if the user cancelled.
Result<QString> printPasswordPaper(const QString& cohort, const std::vector<FirstPassword>& passwords, QWidget* parent);

}  // namespace insonate::ui
