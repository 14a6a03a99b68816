// The dialog to open a link: it offers each type of the table, shows the fields of that type and makes its URL.
#include "core/link/link_url.h"
#include "tests/support/test_runner.h"
#include "ui/links/link_dialog.h"

#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
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
    void wrongAddressesAreRefused_data();
    void wrongAddressesAreRefused();
    void ownLinksAreRefused_data();
    void ownLinksAreRefused();
    void startsWithTheGivenLink_data();
    void startsWithTheGivenLink();
    void saysHowLongTheLinkStays();

private:
    /// Over what is there.
    static void type(QWidget *field, const QString &text)
    {
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
    }
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

void LinkDialogTest::wrongAddressesAreRefused_data()
{
    QTest::addColumn<QString>("host");
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char *name, const char *host, const char *port, const char *reason) {
        QTest::newRow(name) << QString::fromUtf8(host) << QString::fromUtf8(port) << QString::fromUtf8(reason);
    };
    row("good", "drone.example.org", "14550", "");
    row("two dots", "nohost..bad", "14550", "\"nohost..bad\" is not a host name or address");
    row("hyphen at the end", "drone-.org", "14550", "is not a host name");
    row("port beyond 16 bits", "drone", "99999", "the port \"99999\" is not a number from 1 to 65535");
    row("greatest port", "drone", "65535", "");
}

void LinkDialogTest::wrongAddressesAreRefused()
{
    QFETCH(QString, host);
    QFETCH(QString, port);
    QFETCH(QString, reason);
    LinkDialog dialog(QStringLiteral("udpout:127.0.0.1:14550"));
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    type(dialog.findChild<QWidget *>(QStringLiteral("linkHost")), host);
    type(dialog.findChild<QWidget *>(QStringLiteral("linkPort")), port);
    const auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    const QString said = dialog.findChild<QLabel *>(QStringLiteral("linkResult"))->text();
    QCOMPARE(ok->isEnabled(), reason.isEmpty());
    QVERIFY2(said.contains(reason.isEmpty() ? host + QLatin1Char(':') + port : reason), qPrintable(said));
}

void LinkDialogTest::ownLinksAreRefused_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("host");
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char *kind, const char *host, const char *port, const char *reason) {
        QTest::addRow("%s:%s:%s", kind, host, port)
            << QString::fromUtf8(kind) << QString::fromUtf8(host) << QString::fromUtf8(port) << QString::fromUtf8(reason);
    };
    row("udpout", "127.0.0.1", "14550", "itself listens there, with udpin:0.0.0.0:14550");
    row("udpout", "127.0.0.1", "14551", "");
    row("udpout", "192.0.2.7", "14550", "");
    row("udpin", "0.0.0.0", "14550", "already listens there, with udpin:0.0.0.0:14550");
    row("udpin", "127.0.0.1", "15000", "itself sends there, with udpout:127.0.0.1:15000");
    row("tcp", "127.0.0.1", "14550", "");
}

void LinkDialogTest::ownLinksAreRefused()
{
    QFETCH(QString, kind);
    QFETCH(QString, host);
    QFETCH(QString, port);
    QFETCH(QString, reason);
    LinkDialog dialog(kind + QStringLiteral(":10.1.2.3:1"));
    dialog.setOwnLinks({*link::LinkUrl::parse("udpin:0.0.0.0:14550"), *link::LinkUrl::parse("udpout:127.0.0.1:15000")});
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    type(dialog.findChild<QWidget *>(QStringLiteral("linkHost")), host);
    type(dialog.findChild<QWidget *>(QStringLiteral("linkPort")), port);
    const auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    const QString said = dialog.findChild<QLabel *>(QStringLiteral("linkResult"))->text();
    QVERIFY2(ok->isEnabled() == reason.isEmpty(), qPrintable(said));
    QVERIFY2(said.contains(reason), qPrintable(said));
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

void LinkDialogTest::saysHowLongTheLinkStays()
{
    LinkDialog dialog(QStringLiteral("udpin:0.0.0.0:14550"));
    dialog.show();
    const auto *how = dialog.findChild<QLabel *>(QStringLiteral("linkHowLong"));
    QVERIFY(how && how->isVisible());
    QVERIFY2(how->text().contains(QStringLiteral("until Skyseal closes")), qPrintable(how->text()));
}

SKYSEAL_TEST_WIDGETS(LinkDialogTest)
#include "link_dialog_test.moc"
