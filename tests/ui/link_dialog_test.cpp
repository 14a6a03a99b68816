// The dialog to open a link: it offers each type of the table, shows the fields of that type and makes its URL.
#include "core/link/link_url.h"
#include "tests/support/test_runner.h"
#include "ui/links/link_dialog.h"

#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QSpinBox>

using namespace skyseal;
using namespace skyseal::ui;
using link::LinkTarget;
using link::LinkType;

class LinkDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsTheFieldsOfEachType();
    void startsWithTheGivenLink_data();
    void startsWithTheGivenLink();
};

void LinkDialogTest::showsTheFieldsOfEachType()
{
    LinkDialog dialog(QStringLiteral("udpin:0.0.0.0:14550"));
    dialog.show();
    auto *kind = dialog.findChild<QComboBox *>(QStringLiteral("linkKind"));
    auto *path = dialog.findChild<QLineEdit *>(QStringLiteral("linkPath"));
    const auto isShown = [&](const char *name) { return dialog.findChild<QWidget *>(QLatin1String(name))->isVisible(); };
    QCOMPARE(kind->count(), int(link::linkTypes().size()));
    path->setText(QStringLiteral("/dev/null"));
    for (int i = 0; i < kind->count(); ++i) {
        const LinkType &type = link::linkTypes()[std::size_t(i)];
        kind->setCurrentIndex(i);
        QCOMPARE(kind->currentText(), QString::fromUtf8(type.label));
        QCOMPARE(kind->currentData(Qt::ToolTipRole).toString(), QString::fromUtf8(type.hint));
        QCOMPARE(isShown("linkHost"), type.target == LinkTarget::HostPort);
        QCOMPARE(isShown("linkPort"), type.target == LinkTarget::HostPort);
        QCOMPARE(isShown("linkPath"), type.target != LinkTarget::HostPort);
        QCOMPARE(isShown("linkBaud"), type.target == LinkTarget::DeviceBaud);
        const auto url = link::LinkUrl::parse(dialog.url().toStdString());
        QVERIFY2(url.has_value(), qPrintable(dialog.url()));
        QCOMPARE(&url->type(), &type);
        if (type.target == LinkTarget::HostPort)
            QCOMPARE(url->host(), std::string(type.traits.isListening ? "0.0.0.0" : "127.0.0.1"));
    }
}

void LinkDialogTest::startsWithTheGivenLink_data()
{
    QTest::addColumn<QString>("url");
    for (const char *url : {"udpin:127.0.0.2:14999", "udpout:[::1]:5", "tcp:drone:5760", "tcpin:0.0.0.0:5760",
                            "serial:/dev/ttyACM0:115200", "serial:/dev/ttyS0:1500000", "tlog:/tmp/a b.tlog"})
        QTest::newRow(url) << QString::fromUtf8(url);
}

void LinkDialogTest::startsWithTheGivenLink()
{
    QFETCH(QString, url);
    QCOMPARE(LinkDialog(url).url(), url);
}

SKYSEAL_TEST_WIDGETS(LinkDialogTest)
#include "link_dialog_test.moc"
