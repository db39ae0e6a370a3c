// SPDX-License-Identifier: GPL-3.0-or-later
// A phone, another phone, and somebody who is not welcome, over HTTP.
#include "phone.h"
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"

#include "spherewalk/practice/fault.h"

#include <QRegularExpression>
#include <QTranslator>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

class PhoneRemoteTest : public RemoteFixture {
  protected:
    /// Waits until the small picture of the photo is there.
    QJsonObject lookAtPhoto(Phone& phone) {
        QJsonObject state;
        EXPECT_TRUE(QTest::qWaitFor([&] {
            state = phone.look();
            return state["latest"].toObject()["hasPicture"].toBool();
        }));
        return state;
    }
};

} // namespace

TEST_F(PhoneRemoteTest, WithoutPairingOnlyThePageIsServed) {
    begin();
    const Phone stranger(remote.url());
    const QByteArray name = session->name().toUtf8();
    const QByteArray station = desk().nextText().toUtf8();
    const Reply page = stranger.get("/");
    EXPECT_EQ(page.status, 200);
    EXPECT_FALSE(page.body.contains(name) || page.body.contains(station));
    for (const char* place :
         {"/state", "/photo", "/photo?n=1", "/shoot", "/again", "/remote.html", "/survey.db",
          "/../../../../etc/passwd", "/%2e%2e/etc/passwd", "//", "http://elsewhere/"}) {
        for (const Reply& reply : {stranger.get(place), stranger.post(place, "{}")}) {
            EXPECT_EQ(reply.status, 403) << place;
            EXPECT_FALSE(reply.body.contains(name) || reply.body.contains(station)) << place;
        }
    }
    EXPECT_EQ(desk().state(), State::AtStation);
}

TEST_F(PhoneRemoteTest, TheFormShowsAllOfItsWords) {
    const auto expectWhole = [&] {
        for (const QLabel* label : form.findChildren<QLabel*>()) {
            if (label->wordWrap() && !label->text().isEmpty()) {
                EXPECT_GE(label->height(), label->heightForWidth(label->width()))
                    << label->text().toStdString();
            }
        }
    };
    expectWhole();
    press("toggleRemote"); // off
    RemoteForm alone(remote, {});
    alone.show();
    QCoreApplication::processEvents();
    expectWhole();
    for (const QLabel* label : alone.findChildren<QLabel*>()) {
        EXPECT_TRUE(!label->wordWrap() || label->text().isEmpty() ||
                    label->height() >= label->heightForWidth(label->width()))
            << label->text().toStdString();
    }
}

TEST_F(PhoneRemoteTest, ThePageUsesNothingFromElsewhere) {
    const Reply page = Phone(remote.url()).get("/");
    static const QRegularExpression elsewhere("https?:|[\"'(=]//|url\\(|@import|\\{\\{");
    EXPECT_FALSE(QString(page.body).contains(elsewhere)) << page.body.toStdString();
    EXPECT_TRUE(page.head.contains("Content-Security-Policy: default-src 'none'; script-src 'nonce-"));
    EXPECT_TRUE(page.head.contains("Cache-Control: no-store"));
    EXPECT_TRUE(page.head.contains("X-Frame-Options: DENY"));
    EXPECT_NE(Phone(remote.url()).get("/").head, page.head) << "the same nonce twice";
}

TEST_F(PhoneRemoteTest, ThePageSpeaksTheWindowsLanguage) {
    for (const auto& [language, title] :
         {std::pair("de", "Letztes Foto"), std::pair("pl", "Ostatnie zdjęcie")}) {
        QTranslator words;
        ASSERT_TRUE(loadWords(words, QLocale(language)));
        QCoreApplication::installTranslator(&words);
        const QString page = Phone(remote.url()).get("/").body;
        EXPECT_TRUE(page.contains(QString("<html lang=\"%1\">").arg(language)));
        EXPECT_TRUE(page.contains(title));
        QCoreApplication::removeTranslator(&words);
    }
}

TEST_F(PhoneRemoteTest, TheCodePairsOneDeviceAndNoOther) {
    const std::string read = code();
    Phone first(remote.url());
    EXPECT_EQ(first.pair("000").status, 403);
    EXPECT_EQ(first.look()["turn"], QJsonValue());
    const Reply paired = first.pair(read);
    EXPECT_EQ(paired.status, 200);
    EXPECT_TRUE(paired.head.contains("; HttpOnly; SameSite=Strict")) << paired.head.toStdString();
    EXPECT_TRUE(first.look()["turn"].isDouble());
    EXPECT_FALSE(code() == read) << "the window goes on showing the code";
    EXPECT_TRUE(label("remoteState").contains("127.0.0.1"));
    for (int i = 0; i < 2; ++i) { // a second and a third device
        Phone other(remote.url());
        const Reply refused = other.pair(read);
        EXPECT_EQ(refused.status, 403);
        EXPECT_FALSE(refused.sentence().isEmpty());
        EXPECT_EQ(other.get("/state").status, 403);
    }
    EXPECT_EQ(first.get("/state").status, 200);
    press("renewRemoteCode"); // lets go of it
    EXPECT_EQ(first.get("/state").status, 403);
    EXPECT_EQ(Phone(remote.url()).pair(code()).status, 200);
}

TEST_F(PhoneRemoteTest, GuessingEndsAtTheWindow) {
    const std::string read = code();
    Phone phone(remote.url());
    for (int i = 0; i < Pairing::kTries; ++i) {
        EXPECT_EQ(phone.pair("guess").status, 403);
    }
    EXPECT_EQ(phone.pair(read).status, 403);
    EXPECT_TRUE(label("remoteState").contains("void"));
    press("renewRemoteCode");
    EXPECT_EQ(phone.pair(code()).status, 200);
}

TEST_F(PhoneRemoteTest, ShowsWhatTheWindowShows) {
    begin();
    Phone phone = pairedPhone();
    const QJsonObject state = phone.look();
    const auto shows = [&](const char* widget) { return mode.findChild<QLabel*>(widget)->text(); };
    EXPECT_EQ(state["survey"].toString(), session->name());
    EXPECT_EQ(state["station"].toString(), mode.findChild<BigText*>("nextStation")->text());
    EXPECT_EQ(state["way"].toString(), shows("way"));
    EXPECT_EQ(state["state"].toString(), shows("captureState"));
    EXPECT_EQ(state["key"].toString(), mode.findChild<QPushButton*>("shutter")->text());
    EXPECT_EQ(state["practice"].toString(), shows("practiceWords"));
    EXPECT_TRUE(state["left"].toString().contains(QString::number(desk().stationsLeft())));
    mode.setSession(nullptr);
    EXPECT_FALSE(phone.look()["takesKey"].toBool());
    EXPECT_EQ(phone.look()["station"].toString(), QString());
}

TEST_F(PhoneRemoteTest, OnePressIsOnePhotoHoweverOftenItArrives) {
    connectPractice();
    Phone phone = pairedPhone();
    EXPECT_EQ(phone.shoot("start", phone.look()).status, 200);
    waitFor(State::AtStation);
    const QJsonObject seen = phone.look();
    EXPECT_EQ(phone.shoot("a", seen).status, 200);
    EXPECT_EQ(phone.shoot("a", seen).status, 200) << "its answer was lost on the way";
    EXPECT_EQ(phone.shoot("b", seen).status, 409) << "a second tap";
    waitForPhotos(1);
    EXPECT_EQ(phone.shoot("a", seen).status, 200);
    EXPECT_EQ(phone.shoot("a", phone.look()).status, 200);
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(phone.shoot("c", phone.look()).status, 200);
    waitForPhotos(2);
    EXPECT_EQ(exposures(), 2);
}

TEST_F(PhoneRemoteTest, APressForAnotherStationIsRefusedAndSaid) {
    begin();
    Phone phone = pairedPhone();
    const QJsonObject seen = phone.look();
    desk().trigger(); // at the window
    waitForPhotos(1);
    const Reply refused = phone.shoot("a", seen);
    EXPECT_EQ(refused.status, 409);
    EXPECT_TRUE(refused.sentence().contains("another station")) << refused.sentence().toStdString();
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(phone.shoot("b", phone.look()).status, 200);
    waitForPhotos(2);
    EXPECT_EQ(exposures(), 2);
}

TEST_F(PhoneRemoteTest, APressThatTheNetworkDelayedIsRefused) {
    begin();
    Phone phone = pairedPhone();
    const QJsonObject seen = phone.look();
    clock.advance(DeskRemote::kLate + std::chrono::milliseconds(1));
    EXPECT_EQ(phone.shoot("a", seen).status, 409);
    EXPECT_EQ(desk().state(), State::AtStation);
    QJsonObject future = phone.look();
    future["seen"] = future["seen"].toDouble() + 1;
    EXPECT_EQ(phone.shoot("b", future).status, 409);
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(phone.shoot("c", phone.look()).status, 200);
    EXPECT_EQ(desk().state(), State::Shooting);
}

TEST_F(PhoneRemoteTest, APressNeedsTheTokenAndAWholeBody) {
    begin();
    Phone phone = pairedPhone();
    const QJsonObject state = phone.look();
    const QByteArray whole = Phone::press("a", state["turn"], state);
    const QByteArray token = "X-Spherewalk-Token: " + state["token"].toString().toUtf8() + "\r\n";
    EXPECT_EQ(phone.post("/shoot", whole).status, 403);
    EXPECT_EQ(phone.post("/shoot", whole, "X-Spherewalk-Token: 1\r\n").status, 403);
    EXPECT_EQ(phone.post("/shoot", whole, token + "Origin: http://elsewhere\r\n").status, 403);
    for (const QByteArray& body :
         {QByteArray(), QByteArray("[]"), QByteArray("{\"id\":1}"), QByteArray("\xff\xfe{"),
          QByteArray(1000, '['), Phone::press("", state["turn"], state),
          Phone::press(QString(65, 'a'), state["turn"], state), Phone::press("a", "1", state),
          Phone::press("a", -1, state), Phone::press("a", 1.5, state)}) {
        EXPECT_EQ(phone.post("/shoot", body, token).status, 400) << body.toStdString();
    }
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(phone.get("/shoot").status, 404) << "a GET changes nothing";
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(phone.post("/shoot", whole, token).status, 200);
}

TEST_F(PhoneRemoteTest, OtherNamesOfTheComputerAreRefused) {
    const QUrl url(remote.url());
    for (const QByteArray& head :
         {QByteArray("GET / HTTP/1.1\r\n\r\n"), QByteArray("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"),
          QByteArray("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")}) {
        EXPECT_EQ(sendRaw(url, head).status, 403) << head.toStdString();
    }
    const QByteArray host = "Host: " + url.authority().toUtf8() + "\r\n\r\n";
    EXPECT_EQ(sendRaw(url, "PUT / HTTP/1.1\r\n" + host).status, 405);
    EXPECT_EQ(sendRaw(url, "GET / HTTP/1.1\r\n" + host).status, 200);
}

TEST_F(PhoneRemoteTest, ShowsTheLastPhotoWithItsVerdict) {
    begin();
    Phone phone = pairedPhone();
    EXPECT_EQ(phone.get("/photo").status, 404);
    const QString station = desk().nextText();
    phone.shoot("a", phone.look());
    waitForPhotos(1);
    const QJsonObject latest = lookAtPhoto(phone)["latest"].toObject();
    EXPECT_EQ(latest["station"].toString(), station);
    EXPECT_EQ(latest["quality"].toString(), "good");
    EXPECT_FALSE(latest["verdict"].toString().isEmpty());
    const Reply photo = phone.get("/photo?n=1");
    EXPECT_TRUE(photo.head.contains("Content-Type: image/jpeg"));
    const QImage picture = QImage::fromData(photo.body);
    EXPECT_GE(picture.width(), 512);
    EXPECT_EQ(picture.width(), 2 * picture.height());
    EXPECT_LT(photo.body.size(), 300'000) << "too much for a slow network";
}

TEST_F(PhoneRemoteTest, ThePhotoThatIsShownIsTakenAgainBeforeTheNext) {
    begin();
    Phone phone = pairedPhone();
    const std::int64_t station = desk().next()->id;
    phone.shoot("a", phone.look());
    waitForPhotos(1);
    const QJsonObject seen = lookAtPhoto(phone);
    QJsonObject other = seen;
    other["latest"] = QJsonObject{{"photo", seen["latest"].toObject()["photo"].toDouble() - 1}};
    EXPECT_EQ(phone.again("b", other).status, 409) << "of another photo";
    EXPECT_EQ(phone.again("c", seen).status, 200);
    EXPECT_EQ(phone.again("c", seen).status, 200);
    waitUntil([&] { return desk().state() == State::AtStation && desk().next()->id == station; });
    phone.shoot("d", phone.look());
    waitForPhotos(2);
    EXPECT_EQ(session->store().photosAt(station).size(), 2U);
    EXPECT_EQ(exposures(), 2);
    EXPECT_NE(desk().next()->id, station);
}

TEST_F(PhoneRemoteTest, SaysWhatWentWrongAndTriesAgain) {
    begin();
    Phone phone = pairedPhone();
    desk().practice()->camera().arm(
        {practice::FaultKind::ServiceUnavailable, "camera.takePicture", 0, 50, 0});
    phone.shoot("a", phone.look());
    waitFor(State::AskAgain);
    const QJsonObject state = phone.look();
    EXPECT_EQ(state["trouble"].toString(), desk().sentence());
    EXPECT_FALSE(state["trouble"].toString().isEmpty());
    EXPECT_EQ(state["key"].toString(), "Try again");
    EXPECT_EQ(phone.shoot("b", state).status, 200);
    waitUntil([&] { return desk().state() == State::AskAgain && played.size() == 2; });
    EXPECT_EQ(phone.shoot("a", phone.look()).status, 200) << "answered as before";
    EXPECT_EQ(phone.shoot("b", phone.look()).status, 200);
    EXPECT_EQ(phone.shoot("c", state).status, 409) << "for the try before";
    EXPECT_EQ(desk().state(), State::AskAgain) << "none of them tries again";
}

TEST_F(PhoneRemoteTest, AfterTurningOffNothingIsServed) {
    Phone phone = pairedPhone();
    press("toggleRemote");
    EXPECT_FALSE(remote.isOn());
    EXPECT_EQ(phone.get("/").status, 0);
    press("toggleRemote");
    phone.goTo(remote.url());
    EXPECT_EQ(phone.get("/state").status, 403) << "the old cookie";
}

TEST(PhoneRemote, IsOffUntilAPersonTurnsItOnInCapture) {
    MainWindow window;
    window.show();
    auto* button = window.findChild<QPushButton*>("phoneRemote");
    ASSERT_NE(button, nullptr);
    const QString off = button->text();
    button->click();
    button->click();
    ASSERT_EQ(window.findChildren<RemoteForm*>().size(), 1);
    auto* form = window.findChild<RemoteForm*>("remoteForm");
    auto* remote = window.findChild<PhoneRemote*>();
    EXPECT_FALSE(remote->isOn());
    remote->turnOn(QHostAddress(QHostAddress::LocalHost)); // tests may run where there is no network
    EXPECT_NE(button->text(), off);
    EXPECT_EQ(form->findChild<QLabel*>("remoteAddress")->text(), remote->url());
    form->close();
    EXPECT_TRUE(remote->isOn());
    remote->turnOff();
    EXPECT_EQ(button->text(), off);
}

} // namespace spherewalk::ui
