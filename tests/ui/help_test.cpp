// The help pages: what they link to and show exists, and they can be read by keyboard alone.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/dialogs/help_page.h"
#include "window_rig.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtGui/QAction>
#include <QtGui/QTextBlock>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class HelpTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void linksLeadSomewhere()
    {
        static const QRegularExpression kLink(QStringLiteral("\\]\\(([^)]+)\\)"));
        int pictures = 0, links = 0;
        QDirIterator pages(QStringLiteral(":/skyseal/help"), {QStringLiteral("*.md")}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (pages.hasNext()) {
            QFile page(pages.next());
            QVERIFY(page.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(page.readAll());
            for (auto found = kLink.globalMatch(text); found.hasNext();) {
                const QString target = found.next().captured(1);
                const QString shared = QStringLiteral(":/skyseal/help/") + target;
                QVERIFY2(QFile::exists(shared), qPrintable(page.fileName() + QStringLiteral(": ") + target));
                if (target.endsWith(QStringLiteral(".png"))) {
                    QVERIFY2(!QImage(shared).isNull(), qPrintable(target));
                    ++pictures;
                } else {
                    ++links;
                }
            }
        }
        QVERIFY(pictures >= 4);
        QVERIFY(links >= 4);
    }

    void eachWorkspaceHasAPage()
    {
        for (const char *action : {"actionHelpFly", "actionHelpPlan", "actionHelpVehicle", "actionHelpLab"}) {
            find<QAction>(action)->trigger();
            auto *dialog = shownDialog();
            QVERIFY2(dialog, action);
            auto *page = dialog->findChild<HelpPage *>();
            QVERIFY(page->toPlainText().section(QLatin1Char('\n'), 0, 0).endsWith(QStringLiteral(" workspace")));
            QCOMPARE(picturesIn(*page), 1);
            dialog->close();
        }
    }

    /// At any width, and anew when the dialog is resized.
    void picturesAreAsWideAsTheText()
    {
        HelpDialog dialog(QStringLiteral("fly"), {});
        auto *page = dialog.findChild<HelpPage *>();
        for (const int width : {600, 900}) {
            dialog.resize(width, 500);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            const auto textWidth = [page] {
                return qRound(page->viewport()->width() - 2 * page->document()->documentMargin());
            };
            const auto pictureWidth = [page] {
                const QVariant picture = page->document()->resource(QTextDocument::ImageResource,
                                                                    QUrl(QStringLiteral("pictures/fly.png")));
                return qRound(picture.value<QImage>().deviceIndependentSize().width());
            };
            EVENTUALLY_EQUAL(pictureWidth(), textWidth()); // once the scroll bar is there
        }
    }

    void linksAreFollowedByKeyboard()
    {
        HelpDialog dialog(QStringLiteral("lab"), {});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto *page = dialog.findChild<HelpPage *>();
        auto *back = dialog.findChild<QPushButton *>(QStringLiteral("helpBack"));
        page->setFocus();
        QVERIFY(!back->isEnabled());
        QTest::keyClick(page, Qt::Key_Tab); // the first link
        QTest::keyClick(page, Qt::Key_Return);
        QVERIFY2(page->toPlainText().startsWith(QStringLiteral("Sealing a link")), qPrintable(page->toPlainText().left(40)));
        QVERIFY(back->isEnabled());
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QTest::keySequence(page, QKeySequence(QKeySequence::Back));
        EVENTUALLY(page->toPlainText().startsWith(QStringLiteral("The Lab workspace")));
        QVERIFY(!back->isEnabled());
    }

private:
    HelpDialog *shownDialog() const
    {
        for (HelpDialog *dialog : m_window->findChildren<HelpDialog *>())
            if (dialog->isVisible())
                return dialog;
        return nullptr;
    }

    static int picturesIn(const HelpPage &page)
    {
        int out = 0;
        for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                out += part.fragment().charFormat().isImageFormat();
        return out;
    }
};

SKYSEAL_TEST_WIDGETS(HelpTest)
#include "help_test.moc"
