// Input fields are recognizable in every theme: the contrast of their edges, measured in pictures.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/theme/palettes.h"

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include <algorithm>
#include <cmath>

using namespace skyseal::ui;

namespace {

/// WCAG 2.1's relative luminance.
double luminance(const QColor &color)
{
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor &one, const QColor &other)
{
    const auto [low, high] = std::minmax({luminance(one), luminance(other)});
    return (high + 0.05) / (low + 0.05);
}

/// Pixels that are seen to differ: a caret alone is fewer than twice its height.
int differing(const QImage &one, const QImage &other)
{
    int count = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            count += contrast(one.pixelColor(x, y), other.pixelColor(x, y)) > 1.2;
    return count;
}

} // namespace

class ThemeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Not after a Tab alone: the operator must see what the next key meets, as in a dialog that keys have opened.
    void focusIsSeenHoweverItCame_data()
    {
        QTest::addColumn<Theme>("theme");
        QTest::newRow("light") << Theme::Light;
        QTest::newRow("dark") << Theme::Dark;
        QTest::newRow("high contrast") << Theme::HighContrast;
    }

    void focusIsSeenHoweverItCame()
    {
        QFETCH(Theme, theme);
        applyTheme(theme);
        QWidget window;
        auto *row = new QHBoxLayout(&window);
        const QList<QWidget *> controls{new QPushButton(QStringLiteral("Press")), new QCheckBox(QStringLiteral("Check")),
                                        new QComboBox, new QSpinBox, new QLineEdit};
        for (QWidget *control : controls)
            row->addWidget(control);
        window.setFocusPolicy(Qt::StrongFocus);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window, skyseal::test::kDeadlineMs));
        QVERIFY(!window.testAttribute(Qt::WA_KeyboardFocusChange));
        for (QWidget *control : controls) {
            window.setFocus();
            const QImage resting = control->grab().toImage();
            control->setFocus(Qt::OtherFocusReason);
            QVERIFY(control->hasFocus());
            QVERIFY2(differing(control->grab().toImage(), resting) >= 2 * control->height(),
                     control->metaObject()->className());
        }
    }

    void fieldsHaveAnEdge_data()
    {
        QTest::addColumn<Theme>("theme");
        QTest::addColumn<bool>("focused");
        for (const bool focused : {false, true}) {
            const char *word = focused ? "focused" : "resting";
            QTest::addRow("light %s", word) << Theme::Light << focused;
            QTest::addRow("dark %s", word) << Theme::Dark << focused;
            QTest::addRow("high contrast %s", word) << Theme::HighContrast << focused;
        }
    }

    void fieldsHaveAnEdge()
    {
        QFETCH(Theme, theme);
        QFETCH(bool, focused);
        applyTheme(theme);
        QWidget window;
        auto *row = new QHBoxLayout(&window);
        const QList<QWidget *> fields{new QLineEdit, new QSpinBox, new QComboBox, new QPlainTextEdit};
        for (QWidget *field : fields)
            row->addWidget(field);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window, skyseal::test::kDeadlineMs));
        for (QWidget *field : fields) {
            window.setFocus();
            if (focused)
                field->setFocus();
            QCOMPARE(field->hasFocus(), focused);
            const QImage picture = window.grab().toImage();
            // Across the left edge; the caret is further in.
            const QColor around = window.palette().color(QPalette::Window), inside = field->palette().color(QPalette::Base);
            double best = 0;
            for (int x = field->x() - 1; x < field->x() + 3; ++x) {
                const QColor pixel = picture.pixelColor(x, field->y() + field->height() / 2);
                best = std::max(best, std::min(contrast(pixel, around), contrast(pixel, inside)));
            }
            QVERIFY2(best >= 3,
                     qPrintable(QStringLiteral("%1: %2 to 1").arg(QLatin1String(field->metaObject()->className())).arg(best)));
        }
    }
};

SKYSEAL_TEST_WIDGETS(ThemeTest)
#include "theme_test.moc"
