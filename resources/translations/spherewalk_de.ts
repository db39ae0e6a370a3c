<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>CameraPreset</name>
    <message>
        <source>%1, %2 x %3, %4°</source>
        <translation>%1, %2 x %3, %4°</translation>
    </message>
    <message>
        <source>Fisheye (as RealSense T265), 848 x 800</source>
        <translation>Fischauge (wie RealSense T265), 848 x 800</translation>
    </message>
    <message>
        <source>Wide angle</source>
        <translation>Weitwinkel</translation>
    </message>
</context>
<context>
    <name>Cure</name>
    <message>
        <source>Retag</source>
        <translation>Umsetzen</translation>
    </message>
    <message>
        <source>Retake</source>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
</context>
<context>
    <name>Duration</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>ReviewFilter</name>
    <message>
        <source>All stations</source>
        <translation>Alle Standorte</translation>
    </message>
    <message>
        <source>To be reviewed</source>
        <translation>Noch zu sichten</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Zweifelhaft</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>With a note</source>
        <translation>Mit Notiz</translation>
    </message>
    <message>
        <source>With private regions</source>
        <translation>Mit privaten Bereichen</translation>
    </message>
</context>
<context>
    <name>Standing</name>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>aufgenommen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>abgelehnt</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Scans a room with a spherical camera.</source>
        <translation>Nimmt einen Raum mit einer Kugelkamera auf.</translation>
    </message>
    <message>
        <source>Folder of a survey to open</source>
        <translation>Ordner eines Projekts, das geöffnet wird</translation>
    </message>
    <message>
        <source>Photograph the practice room with the practice camera</source>
        <translation>Den Übungsraum mit der Übungskamera aufnehmen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignMode</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Solve how each photo is turned, and see how well it is known</source>
        <translation>Berechnen, wie jedes Foto gedreht ist, und sehen, wie genau das bekannt ist</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>How much work goes into the pictures: about 0.1, 0.5, 1.5 or 3.5 s a photo on one core</source>
        <translation>Wie viel Arbeit in die Bilder geht: etwa 0,1, 0,5, 1,5 oder 3,5 s je Foto auf einem Kern</translation>
    </message>
    <message>
        <source>Eff&amp;ort</source>
        <translation>A&amp;ufwand</translation>
    </message>
    <message>
        <source>What the photos support</source>
        <translation>Was die Fotos hergeben</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Yaw and tilt</source>
        <translation>Drehung und Neigung</translation>
    </message>
    <message>
        <source>And rail placements</source>
        <translation>Dazu Lage der Schienen</translation>
    </message>
    <message>
        <source>And positions</source>
        <translation>Dazu Positionen</translation>
    </message>
    <message>
        <source>What is solved, each with all that the ones above it solve</source>
        <translation>Was berechnet wird; jede Stufe enthält alle darüber</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far photos stand from where they are tagged, one standard deviation</source>
        <translation>Wie weit Fotos von dem Ort stehen, der bei ihnen steht; eine Standardabweichung</translation>
    </message>
    <message>
        <source>&amp;Positions to</source>
        <translation>&amp;Positionen auf</translation>
    </message>
    <message>
        <source>A picture, twice as wide as high, black where photos are not to be looked at: cart, operator</source>
        <translation>Ein Bild, doppelt so breit wie hoch, schwarz, wo Fotos nicht beachtet werden: Wagen, Bediener</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Aus&amp;richten</translation>
    </message>
    <message>
        <source>Solve how each photo is turned</source>
        <translation>Berechnen, wie jedes Foto gedreht ist</translation>
    </message>
    <message>
        <source>Stop; what was found in the pictures is kept for the next run</source>
        <translation>Anhalten; was in den Bildern gefunden wurde, bleibt für das nächste Mal</translation>
    </message>
    <message>
        <source>Only photos with a fla&amp;g</source>
        <translation>Nur Fotos mit Hin&amp;weis</translation>
    </message>
    <message>
        <source>Photos and what the alignment says of them</source>
        <translation>Die Fotos und was das Ausrichten zu ihnen sagt</translation>
    </message>
    <message>
        <source>Re&amp;tag</source>
        <translation>Um&amp;setzen</translation>
    </message>
    <message>
        <source>Move the chosen photos to the stations that fit them</source>
        <translation>Die gewählten Fotos an die Standorte setzen, die zu ihnen passen</translation>
    </message>
    <message>
        <source>Retag a&amp;ll proposed</source>
        <translation>Alle &amp;Vorschläge umsetzen</translation>
    </message>
    <message>
        <source>Move every photo that fits another station there</source>
        <translation>Jedes Foto, das zu einem anderen Standort passt, dorthin setzen</translation>
    </message>
    <message>
        <source>&amp;Retake</source>
        <translation>&amp;Neu aufnehmen</translation>
    </message>
    <message>
        <source>Reject the chosen photos, so that their stations are taken again</source>
        <translation>Die gewählten Fotos ablehnen, damit ihre Standorte neu aufgenommen werden</translation>
    </message>
    <message>
        <source>Headings of the photos</source>
        <translation>Richtungen der Fotos</translation>
    </message>
    <message>
        <source>Lines: how photos are turned. Fans: three standard deviations, %1 times as wide. Colour: standard deviation of the yaw.</source>
        <translation>Striche: wie Fotos gedreht sind. Fächer: drei Standardabweichungen, %1-mal so breit. Farbe: Standardabweichung der Drehung.</translation>
    </message>
    <message>
        <source>Picture that tells what is left out</source>
        <translation>Bild, das sagt, was ausgelassen wird</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>No mas&amp;k...</source>
        <translation>Keine Mas&amp;ke...</translation>
    </message>
    <message>
        <source>Mas&amp;k: %1</source>
        <translation>Mas&amp;ke: %1</translation>
    </message>
    <message>
        <source>As tagged</source>
        <translation>Wie angegeben</translation>
    </message>
    <message>
        <source>From the pictures alone</source>
        <translation>Allein aus den Bildern</translation>
    </message>
    <message>
        <source>Where the photos were taken: as they are tagged, or solved from what they show; then the stations move there</source>
        <translation>Wo die Fotos aufgenommen wurden: wie sie angegeben sind, oder berechnet aus dem, was sie zeigen; die Stationen rücken dann dorthin</translation>
    </message>
    <message>
        <source>Pla&amp;ces</source>
        <translation>&amp;Orte</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Usual height of the lens above the floor: it tells how large everything is</source>
        <translation>Übliche Höhe des Objektivs über dem Boden: sie sagt, wie groß alles ist</translation>
    </message>
    <message>
        <source>Le&amp;ns at</source>
        <translation>Ob&amp;jektiv auf</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignModel</name>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>nicht ausgerichtet</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>Where the photo was taken, in walking order</source>
        <translation>Wo das Foto aufgenommen wurde, in Gehreihenfolge</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>What the alignment says of the photo</source>
        <translation>Was das Ausrichten zum Foto sagt</translation>
    </message>
    <message>
        <source>Yaw °</source>
        <translation>Drehung °</translation>
    </message>
    <message>
        <source>How the photo is turned, counter-clockwise from the room&apos;s x axis</source>
        <translation>Wie das Foto gedreht ist, gegen den Uhrzeigersinn von der x-Achse des Raums</translation>
    </message>
    <message>
        <source>σ yaw °</source>
        <translation>σ Drehung °</translation>
    </message>
    <message>
        <source>Standard deviation of the yaw</source>
        <translation>Standardabweichung der Drehung</translation>
    </message>
    <message>
        <source>σ tilt °</source>
        <translation>σ Neigung °</translation>
    </message>
    <message>
        <source>Standard deviation of pitch or roll, the larger of them</source>
        <translation>Standardabweichung von Nicken oder Rollen, die größere</translation>
    </message>
    <message>
        <source>Residual °</source>
        <translation>Rest °</translation>
    </message>
    <message>
        <source>How far the photo&apos;s matches miss, root mean square</source>
        <translation>Um wie viel die Treffer des Fotos danebenliegen, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Neighbours that hold the photo</source>
        <translation>Nachbarn, die das Foto halten</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Was helfen würde</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>What speaks against the photo</source>
        <translation>Was gegen das Foto spricht</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignPresenter</name>
    <message numerus="yes">
        <source>Move %n photo(s) to other stations</source>
        <translation>
            <numerusform>%n Foto an einen anderen Standort setzen</numerusform>
            <numerusform>%n Fotos an andere Standorte setzen</numerusform>
        </translation>
    </message>
    <message>
        <source>Moved to this station since; align again.</source>
        <translation>Seither an diesen Standort gesetzt; richten Sie erneut aus.</translation>
    </message>
    <message>
        <source>The survey is not aligned yet.</source>
        <translation>Das Projekt ist noch nicht ausgerichtet.</translation>
    </message>
    <message numerus="yes">
        <source>Alignment of %n photo(s): %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>Ausrichtung von %n Foto: %1 gut, %2 zweifelhaft, %3 fehlgeschlagen.</numerusform>
            <numerusform>Ausrichtung von %n Fotos: %1 gut, %2 zweifelhaft, %3 fehlgeschlagen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With what the checks found, %n photo(s) are to be looked at in Review.</source>
        <translation>
            <numerusform>Mit dem, was die Prüfungen fanden, ist %n Foto in Sichten anzusehen.</numerusform>
            <numerusform>Mit dem, was die Prüfungen fanden, sind %n Fotos in Sichten anzusehen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) came since, or were left out: align again.</source>
        <translation>
            <numerusform>%n Foto kam seither dazu oder wurde ausgelassen: richten Sie erneut aus.</numerusform>
            <numerusform>%n Fotos kamen seither dazu oder wurden ausgelassen: richten Sie erneut aus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Model %1.</source>
        <translation>Modell %1.</translation>
    </message>
    <message>
        <source>Aligning %1</source>
        <translation>%1 wird ausgerichtet</translation>
    </message>
    <message numerus="yes">
        <source>Aligned %n photo(s) in %1.</source>
        <translation>
            <numerusform>%n Foto in %1 ausgerichtet.</numerusform>
            <numerusform>%n Fotos in %1 ausgerichtet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped; the survey is as it was.</source>
        <translation>Angehalten; das Projekt ist, wie es war.</translation>
    </message>
    <message>
        <source>Another job is changing the survey; try again when it has ended.</source>
        <translation>Eine andere Aufgabe ändert das Projekt; versuchen Sie es nach deren Ende erneut.</translation>
    </message>
    <message>
        <source>Moving photos to other stations</source>
        <translation>Fotos werden an andere Standorte gesetzt</translation>
    </message>
    <message numerus="yes">
        <source>Moved %n photo(s); align again to be sure.</source>
        <translation>
            <numerusform>%n Foto umgesetzt; richten Sie zur Sicherheit erneut aus.</numerusform>
            <numerusform>%n Fotos umgesetzt; richten Sie zur Sicherheit erneut aus.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no photo to align yet; capture or import some first.</source>
        <translation>Es gibt noch kein Foto auszurichten; nehmen Sie erst welche auf, oder importieren Sie sie.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Application</name>
    <message>
        <source>Spherewalk met a defect of its own: %1.</source>
        <translation>Spherewalk ist auf einen eigenen Fehler gestoßen: %1.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraBox</name>
    <message>
        <source>From a ROS file...</source>
        <translation>Aus einer ROS-Datei...</translation>
    </message>
    <message>
        <source>Camera model</source>
        <translation>Kameramodell</translation>
    </message>
    <message>
        <source>The robot&apos;s camera; a ROS camera-info YAML has your own one&apos;s calibration</source>
        <translation>Die Kamera des Roboters; eine camera-info-YAML von ROS enthält die Kalibrierung der eigenen</translation>
    </message>
    <message>
        <source>ROS camera-info file</source>
        <translation>ROS-Datei camera-info</translation>
    </message>
    <message>
        <source>Camera info (*.yaml *.yml)</source>
        <translation>Kameradaten (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraFinder</name>
    <message>
        <source>Looking for cameras...</source>
        <translation>Kameras werden gesucht...</translation>
    </message>
    <message>
        <source>Looking for cameras</source>
        <translation>Kameras werden gesucht</translation>
    </message>
    <message>
        <source>No camera answers. Switch it on, connect this computer to its WiFi, and look again.</source>
        <translation>Keine Kamera antwortet. Schalten Sie die Kamera ein, verbinden Sie diesen Rechner mit ihrem WLAN, und suchen Sie erneut.</translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s) found</source>
        <translation>
            <numerusform>%n Kamera gefunden</numerusform>
            <numerusform>%n Kameras gefunden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraLogin</name>
    <message>
        <source>The system&apos;s keychain did not keep the password (%1); it is asked for again when the program starts next.</source>
        <translation>Der Schlüsselbund des Systems hat das Passwort nicht behalten (%1); das Programm fragt beim nächsten Start erneut.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraPanel</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Shoot by &amp;itself</source>
        <translation>Von &amp;selbst auslösen</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>Adresse der Kamera</translation>
    </message>
    <message>
        <source>Address of the camera, with :port if it is not 80.</source>
        <translation>Adresse der Kamera, mit :Port, wenn er nicht 80 ist.</translation>
    </message>
    <message>
        <source>Ask the camera at this address how it is.</source>
        <translation>Die Kamera an dieser Adresse fragen, wie es ihr geht.</translation>
    </message>
    <message>
        <source>The camera inside of the program, which photographs a practice room.</source>
        <translation>Die Kamera im Programm, die einen Übungsraum aufnimmt.</translation>
    </message>
    <message>
        <source>Time to hide</source>
        <translation>Zeit zum Verstecken</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>From the key to the shot, so that nobody is in the picture.</source>
        <translation>Von der Taste bis zum Auslösen, damit niemand im Bild ist.</translation>
    </message>
    <message>
        <source>The practice camera moves from station to station without the key.</source>
        <translation>Die Übungskamera geht ohne Taste von Standort zu Standort.</translation>
    </message>
    <message>
        <source>Ti&amp;me to hide:</source>
        <translation>Zeit zum V&amp;erstecken:</translation>
    </message>
    <message>
        <source>Practice camera</source>
        <translation>Übungskamera</translation>
    </message>
    <message>
        <source>The practice camera photographs a room of the program. Its photos would become photos of %1.</source>
        <translation>Die Übungskamera nimmt einen Raum des Programms auf. Ihre Fotos würden Fotos von %1.</translation>
    </message>
    <message>
        <source>&amp;Use it here</source>
        <translation>Hier &amp;verwenden</translation>
    </message>
    <message>
        <source>Fi&amp;nd cameras</source>
        <translation>Kameras &amp;finden</translation>
    </message>
    <message>
        <source>Looks where cameras usually are, and for those that announce themselves on the network.</source>
        <translation>Sucht, wo Kameras meist sind, und nach denen, die sich im Netz melden.</translation>
    </message>
    <message>
        <source>Cameras that were found</source>
        <translation>Gefundene Kameras</translation>
    </message>
    <message>
        <source>Choose the camera to connect to.</source>
        <translation>Wählen Sie die Kamera, mit der verbunden wird.</translation>
    </message>
    <message>
        <source>How the camera is set for the photos of this survey.</source>
        <translation>Wie die Kamera für die Fotos dieses Projekts eingestellt ist.</translation>
    </message>
    <message>
        <source>&amp;Live preview</source>
        <translation>&amp;Live-Bild</translation>
    </message>
    <message>
        <source>What the camera sees, until the picture is taken.</source>
        <translation>Was die Kamera sieht, bis das Foto aufgenommen wird.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Storage of the camera</source>
        <translation>Speicher der Kamera</translation>
    </message>
    <message>
        <source>Temperature of the camera</source>
        <translation>Temperatur der Kamera</translation>
    </message>
    <message>
        <source>Leave the &amp;practice camera</source>
        <translation>Übungs&amp;kamera verlassen</translation>
    </message>
    <message>
        <source>&amp;Practice camera</source>
        <translation>Übungs&amp;kamera</translation>
    </message>
    <message>
        <source>E&amp;xposure: %1</source>
        <translation>Beli&amp;chtung: %1</translation>
    </message>
    <message>
        <source>connecting...</source>
        <translation>verbinde...</translation>
    </message>
    <message>
        <source>no camera</source>
        <translation>keine Kamera</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>practice camera</source>
        <translation>Übungskamera</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>(charging)</source>
        <translation>(lädt)</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s)</source>
        <translation>
            <numerusform>%n Foto</numerusform>
            <numerusform>%n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>zu heiß</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>warm</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>A phone or tablet on the cart shows the next station, shoots, and shows the last photo.</source>
        <translation>Ein Telefon oder Tablet auf dem Wagen zeigt den nächsten Standort, löst aus und zeigt das letzte Foto.</translation>
    </message>
    <message>
        <source>Phone as remote: on...</source>
        <translation>Fernbedienung: an...</translation>
    </message>
    <message>
        <source>Phone as remote...</source>
        <translation>Telefon als Fernbedienung...</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureDesk</name>
    <message>
        <source>Connecting to %1</source>
        <translation>Verbinden mit %1</translation>
    </message>
    <message>
        <source>Starting the practice camera</source>
        <translation>Die Übungskamera wird gestartet</translation>
    </message>
    <message>
        <source>Capturing %1</source>
        <translation>%1 wird aufgenommen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureMode</name>
    <message>
        <source>Capture</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Take the photos, station by station</source>
        <translation>Die Fotos aufnehmen, Standort für Standort</translation>
    </message>
    <message>
        <source>Every station has its photo.</source>
        <translation>Jeder Standort hat sein Foto.</translation>
    </message>
    <message>
        <source>Capturing has ended; it goes on where it stopped.</source>
        <translation>Die Aufnahme ist beendet; es geht dort weiter, wo sie anhielt.</translation>
    </message>
    <message>
        <source>Space, Return, Page Down, or a presenter&apos;s button.</source>
        <translation>Leertaste, Eingabe, Bild ab oder der Knopf eines Presenters.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Sto&amp;pp</translation>
    </message>
    <message>
        <source>Ends after what is stored already; capturing goes on from there later (Escape).</source>
        <translation>Endet nach dem, was schon gespeichert ist; später geht es von dort weiter (Escape).</translation>
    </message>
    <message>
        <source>Align (A)</source>
        <translation>Ausrichten (A)</translation>
    </message>
    <message>
        <source>photos left</source>
        <translation>Fotos übrig</translation>
    </message>
    <message>
        <source>time left</source>
        <translation>Zeit übrig</translation>
    </message>
    <message>
        <source>photos a minute</source>
        <translation>Fotos je Minute</translation>
    </message>
    <message>
        <source>To be taken again</source>
        <translation>Neu aufzunehmen</translation>
    </message>
    <message>
        <source>Puts the station that is selected on the plan on the list, or takes it off.</source>
        <translation>Setzt den im Plan gewählten Standort auf die Liste oder nimmt ihn herunter.</translation>
    </message>
    <message>
        <source>PRACTICE. %1</source>
        <translation>ÜBUNG. %1</translation>
    </message>
    <message>
        <source>%1 taken, %2 doubtful, %3 failed</source>
        <translation>%1 aufgenommen, %2 zweifelhaft, %3 fehlgeschlagen</translation>
    </message>
    <message numerus="yes">
        <source>Look at %n in Review (R)</source>
        <translation>
            <numerusform>%n in Sichten ansehen (R)</numerusform>
            <numerusform>%n in Sichten ansehen (R)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Take %n again (T)</source>
        <translation>
            <numerusform>%n neu aufnehmen (T)</numerusform>
            <numerusform>%n neu aufnehmen (T)</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at the doubtful photos while the rail is still here.</source>
        <translation>Sehen Sie die zweifelhaften Fotos an, solange die Schiene noch da ist.</translation>
    </message>
    <message>
        <source>Next: solve how each photo is turned.</source>
        <translation>Als Nächstes: berechnen, wie jedes Foto gedreht ist.</translation>
    </message>
    <message>
        <source>Space, Return, Page Down</source>
        <translation>Leertaste, Eingabe, Bild ab</translation>
    </message>
    <message>
        <source>Start, shoot, try again, or end the countdown</source>
        <translation>Beginnen, auslösen, noch einmal oder Herunterzählen beenden</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Stop capturing</source>
        <translation>Aufnahme anhalten</translation>
    </message>
    <message>
        <source>At the end: review, take again, align</source>
        <translation>Am Ende: sichten, neu aufnehmen, ausrichten</translation>
    </message>
    <message>
        <source>Do not take it again</source>
        <translation>Nicht neu aufnehmen</translation>
    </message>
    <message>
        <source>Take the selected station again</source>
        <translation>Den gewählten Standort neu aufnehmen</translation>
    </message>
    <message>
        <source>The walk has ended; another one goes on from here.</source>
        <translation>Der Rundgang ist zu Ende; ein weiterer setzt ihn fort.</translation>
    </message>
    <message>
        <source>photos taken</source>
        <translation>Fotos aufgenommen</translation>
    </message>
    <message>
        <source>of known place</source>
        <translation>mit bekanntem Ort</translation>
    </message>
    <message>
        <source>Go on, or solve where the photos were taken.</source>
        <translation>Machen Sie weiter, oder lassen Sie berechnen, wo die Fotos aufgenommen wurden.</translation>
    </message>
    <message>
        <source>Go on where photos are missing.</source>
        <translation>Machen Sie weiter, wo Fotos fehlen.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CapturePlanView</name>
    <message>
        <source>to be taken again</source>
        <translation>wird neu aufgenommen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureWords</name>
    <message>
        <source>Every station has its photo.</source>
        <translation>Jeder Standort hat sein Foto.</translation>
    </message>
    <message>
        <source>Connect a camera, or try the practice camera.</source>
        <translation>Verbinden Sie eine Kamera, oder probieren Sie die Übungskamera.</translation>
    </message>
    <message>
        <source>Connecting...</source>
        <translation>Verbinde...</translation>
    </message>
    <message>
        <source>The next station:</source>
        <translation>Der nächste Standort:</translation>
    </message>
    <message>
        <source>Preparing the camera...</source>
        <translation>Die Kamera wird vorbereitet...</translation>
    </message>
    <message>
        <source>Bring the camera to</source>
        <translation>Bringen Sie die Kamera zu</translation>
    </message>
    <message>
        <source>No picture was taken at</source>
        <translation>Kein Foto entstand bei</translation>
    </message>
    <message>
        <source>Hide! The picture is taken at</source>
        <translation>Verstecken! Gleich wird aufgenommen:</translation>
    </message>
    <message>
        <source>Taking the picture at</source>
        <translation>Aufgenommen wird</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>Auslösen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>%1 ... (press to wait)</source>
        <translation>%1 ... (Taste: warten)</translation>
    </message>
    <message>
        <source>Please wait</source>
        <translation>Bitte warten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The photo is stored.</source>
        <translation>Das Foto ist gespeichert.</translation>
    </message>
    <message>
        <source>PRACTICE: photos of a room that exists only in the program</source>
        <translation>ÜBUNG: Fotos eines Raums, den es nur im Programm gibt</translation>
    </message>
    <message>
        <source>By hand: walk through the room and shoot.</source>
        <translation>Von Hand: Gehen Sie durch den Raum und lösen Sie aus.</translation>
    </message>
    <message>
        <source>Stand where you like and shoot</source>
        <translation>Stellen Sie sich auf, wo Sie wollen, und lösen Sie aus</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ColumnScrollArea</name>
    <message>
        <source>Column that scrolls</source>
        <translation>Spalte, die sich rollen lässt</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CoreWords</name>
    <message>
        <source>It is %1 pixels wide instead of %2; set the camera&apos;s size and take it again.</source>
        <translation>Es ist %1 Pixel breit statt %2; stellen Sie die Größe an der Kamera ein, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It says that it is no whole stitched sphere; switch stitching on in the camera and take it again.</source>
        <translation>Es sagt, dass es keine ganze zusammengesetzte Kugel ist; schalten Sie das Zusammensetzen in der Kamera ein, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It says that the camera hung upside down; put it upright and take it again.</source>
        <translation>Es sagt, dass die Kamera kopfüber hing; richten Sie sie auf, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The camera leaned by %1 degrees; check its mount.</source>
        <translation>Die Kamera neigte sich um %1 Grad; prüfen Sie ihre Halterung.</translation>
    </message>
    <message>
        <source>It was exposed for %1 s instead of %2 s; take it again.</source>
        <translation>Es wurde %1 s statt %2 s belichtet; nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It was taken at ISO %1 instead of %2; take it again.</source>
        <translation>Es wurde mit ISO %1 statt %2 aufgenommen; nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It was taken with a fixed white balance, against the survey&apos;s settings; take it again if its colours differ.</source>
        <translation>Es wurde mit festem Weißabgleich aufgenommen, anders als das Projekt vorgibt; nehmen Sie es neu auf, wenn seine Farben abweichen.</translation>
    </message>
    <message>
        <source>It was taken with automatic white balance, against the survey&apos;s settings; take it again if its colours differ.</source>
        <translation>Es wurde mit automatischem Weißabgleich aufgenommen, anders als das Projekt vorgibt; nehmen Sie es neu auf, wenn seine Farben abweichen.</translation>
    </message>
    <message>
        <source>It is too dark; check the lens and the exposure.</source>
        <translation>Es ist zu dunkel; prüfen Sie das Objektiv und die Belichtung.</translation>
    </message>
    <message>
        <source>It is too bright; check the exposure.</source>
        <translation>Es ist zu hell; prüfen Sie die Belichtung.</translation>
    </message>
    <message>
        <source>It is %1 stops darker than its neighbours; check the exposure and the lamps.</source>
        <translation>Es ist %1 Blenden dunkler als seine Nachbarn; prüfen Sie die Belichtung und die Lampen.</translation>
    </message>
    <message>
        <source>It is %1 stops brighter than its neighbours; check the exposure and the lamps.</source>
        <translation>Es ist %1 Blenden heller als seine Nachbarn; prüfen Sie die Belichtung und die Lampen.</translation>
    </message>
    <message>
        <source>It is %1 stops darker than %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Es ist %1 Blenden dunkler als %2, und zu wenige Fotos sagen, welches der beiden falsch ist; sehen Sie beide an, und nehmen Sie das falsche neu auf.</translation>
    </message>
    <message>
        <source>It is %1 stops brighter than %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Es ist %1 Blenden heller als %2, und zu wenige Fotos sagen, welches der beiden falsch ist; sehen Sie beide an, und nehmen Sie das falsche neu auf.</translation>
    </message>
    <message>
        <source>Its colours differ by %1 % from those of %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Seine Farben weichen um %1 % von denen von %2 ab, und zu wenige Fotos sagen, welches der beiden falsch ist; sehen Sie beide an, und nehmen Sie das falsche neu auf.</translation>
    </message>
    <message>
        <source>Its colours differ by %1 % from its neighbours&apos;; fix the white balance, and check the lamps.</source>
        <translation>Seine Farben weichen um %1 % von denen seiner Nachbarn ab; legen Sie den Weißabgleich fest, und prüfen Sie die Lampen.</translation>
    </message>
    <message>
        <source>%1 % of it is black; check that nothing covers a lens.</source>
        <translation>%1 % davon sind schwarz; prüfen Sie, dass nichts ein Objektiv bedeckt.</translation>
    </message>
    <message>
        <source>%1 % of it is burnt out; shorten the exposure, or keep the light out.</source>
        <translation>%1 % davon sind ausgebrannt; belichten Sie kürzer, oder halten Sie das Licht fern.</translation>
    </message>
    <message>
        <source>Something is in view that its neighbours do not show, %1 degrees to the left of the picture&apos;s middle (%2 % of the sphere); if it is a person, step aside and take it again.</source>
        <translation>Etwas ist im Bild, das seine Nachbarn nicht zeigen, %1 Grad links von der Bildmitte (%2 % der Kugel); ist es ein Mensch, treten Sie beiseite, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>Something is in view that its neighbours do not show, %1 degrees to the right of the picture&apos;s middle (%2 % of the sphere); if it is a person, step aside and take it again.</source>
        <translation>Etwas ist im Bild, das seine Nachbarn nicht zeigen, %1 Grad rechts von der Bildmitte (%2 % der Kugel); ist es ein Mensch, treten Sie beiseite, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The camera was turned by %1 degrees against its neighbours, which all look one way; check its mount.</source>
        <translation>Die Kamera war um %1 Grad gegen ihre Nachbarn gedreht, die alle in eine Richtung sehen; prüfen Sie ihre Halterung.</translation>
    </message>
    <message>
        <source>It is blurred: its edges are %1 times as wide as they should be; let the camera come to rest and take it again.</source>
        <translation>Es ist unscharf: seine Kanten sind %1-mal so breit, wie sie sein sollten; lassen Sie die Kamera zur Ruhe kommen, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It is upside down against its neighbours; put the camera upright and take it again.</source>
        <translation>Es steht gegen seine Nachbarn auf dem Kopf; richten Sie die Kamera auf, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>It does not look like its neighbours, however it is turned; check that the camera stood at this station.</source>
        <translation>Es sieht nicht aus wie seine Nachbarn, wie immer man es dreht; prüfen Sie, dass die Kamera an diesem Standort stand.</translation>
    </message>
    <message>
        <source>It shows the same as %1, from the same place: the camera was not moved in between; retake the one whose station is wrong.</source>
        <translation>Es zeigt dasselbe wie %1, vom selben Ort: Die Kamera wurde dazwischen nicht bewegt; nehmen Sie das neu auf, dessen Standort falsch ist.</translation>
    </message>
    <message>
        <source>It seems to stand %1 cm from where it is tagged, farther off than the others: correct its position, or retake it at its station.</source>
        <translation>Es scheint %1 cm von dem Ort zu stehen, der bei ihm steht, weiter als die anderen: berichtigen Sie seine Position, oder nehmen Sie es an seinem Standort neu auf.</translation>
    </message>
    <message>
        <source>Its rotation against its neighbours is known to %1 deg only: it shares too little with them; retake it with more light, or with more to see.</source>
        <translation>Seine Drehung gegen seine Nachbarn ist nur auf %1 Grad bekannt: es hat zu wenig mit ihnen gemeinsam; nehmen Sie es mit mehr Licht neu auf, oder mit mehr zu sehen.</translation>
    </message>
    <message>
        <source>The model yaw does not solve its tilt, so its rotation against its neighbours is known to %1 deg only: take more photos near it.</source>
        <translation>Das Modell yaw bestimmt seine Neigung nicht, darum ist seine Drehung gegen seine Nachbarn nur auf %1 Grad bekannt: nehmen Sie in seiner Nähe mehr Fotos auf.</translation>
    </message>
    <message>
        <source>Its neighbours contradict %1 % of what it shows; look at the picture, and retake it if it is not of this place.</source>
        <translation>Seine Nachbarn widersprechen %1 % dessen, was es zeigt; sehen Sie das Bild an, und nehmen Sie es neu auf, wenn es nicht von diesem Ort ist.</translation>
    </message>
    <message>
        <source>It belongs to a part of the survey that nothing connects with the rest (%1 parts): headings are right within the part, and the part&apos;s own rests on its positions alone; take photos between the parts.</source>
        <translation>Es gehört zu einem Teil des Projekts, den nichts mit dem Rest verbindet (%1 Teile): Richtungen stimmen innerhalb des Teils, und die des Teils beruht nur auf seinen Positionen; nehmen Sie Fotos zwischen den Teilen auf.</translation>
    </message>
    <message>
        <source>Where it was taken is known to %1 cm only: correct its position, or retake it at its station.</source>
        <translation>Wo es aufgenommen wurde, ist nur auf %1 cm bekannt: berichtigen Sie seine Position, oder nehmen Sie es an seinem Standort neu auf.</translation>
    </message>
    <message>
        <source>It was taken at one place with %1, though their tags lie %2 m apart: the camera was not moved between them.</source>
        <translation>Es wurde am selben Ort aufgenommen wie %1, obwohl ihre Orte %2 m auseinanderliegen sollen: die Kamera wurde dazwischen nicht bewegt.</translation>
    </message>
    <message>
        <source>Retake the one whose tag is wrong.</source>
        <translation>Nehmen Sie das neu auf, dessen Ort falsch ist.</translation>
    </message>
    <message>
        <source>There was nothing to solve.</source>
        <translation>Es gab nichts zu berechnen.</translation>
    </message>
    <message>
        <source>It was asked for.</source>
        <translation>Es wurde verlangt.</translation>
    </message>
    <message>
        <source>Photos with wrong tags are solved with their places.</source>
        <translation>Fotos mit falschem Ort werden mit ihrem Ort berechnet.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; is the richest, and every step to it helped: matches that were held out miss by %2.</source>
        <translation>Das Modell &apos;%1&apos; ist das reichste, und jeder Schritt dahin hat geholfen: zurückgehaltene Treffer liegen daneben um %2.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; is the richest whose gain exceeds its noise: matches that were held out miss by %2.</source>
        <translation>Das Modell &apos;%1&apos; ist das reichste, dessen Gewinn sein Rauschen übersteigt: zurückgehaltene Treffer liegen daneben um %2.</translation>
    </message>
    <message>
        <source>There is something by the name %1 already; choose another name, or remove it.</source>
        <translation>Es gibt schon etwas mit dem Namen %1; wählen Sie einen anderen Namen, oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>1 station has no photo: near them, views come from farther away.</source>
        <translation>1 Standort hat kein Foto: in seiner Nähe kommen Ansichten von weiter weg.</translation>
    </message>
    <message>
        <source>%1 stations have no photo: near them, views come from farther away.</source>
        <translation>%1 Standorte haben kein Foto: in ihrer Nähe kommen Ansichten von weiter weg.</translation>
    </message>
    <message>
        <source>1 photo was rejected and is left out.</source>
        <translation>1 Foto wurde abgelehnt und wird ausgelassen.</translation>
    </message>
    <message>
        <source>%1 photos were rejected and are left out.</source>
        <translation>%1 Fotos wurden abgelehnt und werden ausgelassen.</translation>
    </message>
    <message>
        <source>%1 photos have no known heading: they would be exported as if they looked along the room&apos;s x axis; align again, or reject them.</source>
        <translation>%1 Fotos haben keine bekannte Richtung: sie würden exportiert, als sähen sie die x-Achse des Raums entlang; richten Sie erneut aus, oder lehnen Sie sie ab.</translation>
    </message>
    <message>
        <source>The alignment of %1 photos is doubtful; review them, or export them as they are.</source>
        <translation>Die Ausrichtung von %1 Fotos ist zweifelhaft; sichten Sie sie, oder exportieren Sie sie, wie sie sind.</translation>
    </message>
    <message>
        <source>The alignment of 1 photo is doubtful; review it, or export it as it is.</source>
        <translation>Die Ausrichtung von 1 Foto ist zweifelhaft; sichten Sie es, oder exportieren Sie es, wie es ist.</translation>
    </message>
    <message>
        <source>The cheapest that holds %1 px is the scene model %2 with sampling %3: 95 of 100 places are displaced by at most %4 px, in %5 ms a view.</source>
        <translation>Das billigste, das %1 px hält, ist das Szenenmodell %2 mit der Abtastung %3: 95 von 100 Stellen sind um höchstens %4 px verschoben, in %5 ms je Ansicht.</translation>
    </message>
    <message>
        <source>No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model %2 with sampling %3, reaches %4 px.</source>
        <translation>Keine Möglichkeit dieses Datensatzes hält %1 px an 95 von 100 Stellen; die beste, das Szenenmodell %2 mit der Abtastung %3, erreicht %4 px.</translation>
    </message>
    <message>
        <source>Take photos closer together.</source>
        <translation>Nehmen Sie Fotos dichter beieinander auf.</translation>
    </message>
    <message>
        <source>No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model %2 with sampling %3, misses more than 5 of 100 places.</source>
        <translation>Keine Möglichkeit dieses Datensatzes hält %1 px an 95 von 100 Stellen; die beste, das Szenenmodell %2 mit der Abtastung %3, verfehlt mehr als 5 von 100 Stellen.</translation>
    </message>
    <message>
        <source>Take photos closer together, or export the dataset with a richer scene model.</source>
        <translation>Nehmen Sie Fotos dichter beieinander auf, oder exportieren Sie den Datensatz mit einem reicheren Szenenmodell.</translation>
    </message>
    <message>
        <source>Could not reach the camera at %1 within %2; press its power button in case it sleeps, and check that this computer is on the camera&apos;s WiFi.</source>
        <translation>Die Kamera bei %1 war in %2 nicht zu erreichen; drücken Sie ihre Ein-Taste, falls sie schläft, und prüfen Sie, ob dieser Rechner in ihrem WLAN ist.</translation>
    </message>
    <message>
        <source>No answer from the camera at %1 within %2; press its power button in case it sleeps, and check the WiFi.</source>
        <translation>Die Kamera bei %1 hat in %2 nicht geantwortet; drücken Sie ihre Ein-Taste, falls sie schläft, und prüfen Sie das WLAN.</translation>
    </message>
    <message>
        <source>Could not reach the camera at %1 (%2); check that it is switched on, that no USB data cable is plugged in, and that this computer is on its WiFi.</source>
        <translation>Die Kamera bei %1 war nicht zu erreichen (%2); prüfen Sie, ob sie eingeschaltet ist, kein USB-Datenkabel steckt und dieser Rechner in ihrem WLAN ist.</translation>
    </message>
    <message>
        <source>The connection to the camera at %1 broke (%2); move closer to the camera, check the WiFi, and try again.</source>
        <translation>Die Verbindung zur Kamera bei %1 ist abgerissen (%2); gehen Sie näher an die Kamera, prüfen Sie das WLAN, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>What answers at %1 does not speak HTTP; check the address of the camera.</source>
        <translation>Was bei %1 antwortet, spricht kein HTTP; prüfen Sie die Adresse der Kamera.</translation>
    </message>
    <message>
        <source>What answers at %1 sent more than a camera would; check the address.</source>
        <translation>Was bei %1 antwortet, hat mehr geschickt, als eine Kamera täte; prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>What answers at http://%1 is not a spherical camera (%2); check that this computer is on the camera&apos;s WiFi and not also on another network with the same addresses, and check the address.</source>
        <translation>Was bei http://%1 antwortet, ist keine Kugelkamera (%2); prüfen Sie die Adresse, und ob dieser Rechner im WLAN der Kamera ist und nicht auch in einem anderen Netz mit denselben Adressen.</translation>
    </message>
    <message>
        <source>The download from the camera at %1 stood still for %2; move closer to the camera and try again.</source>
        <translation>Das Laden von der Kamera bei %1 stand %2 lang still; gehen Sie näher an die Kamera, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The camera&apos;s address &quot;%1&quot; cannot be used; write it like 192.168.1.1 or http://127.0.0.1:8080.</source>
        <translation>Die Adresse &quot;%1&quot; ist für eine Kamera nicht zu gebrauchen; schreiben Sie etwa 192.168.1.1 oder http://127.0.0.1:8080.</translation>
    </message>
    <message>
        <source>The camera named a photo by &quot;%1&quot;, which is not a usable URL; update its firmware.</source>
        <translation>Die Kamera nennt ein Foto &quot;%1&quot;, was keine brauchbare URL ist; erneuern Sie ihre Firmware.</translation>
    </message>
    <message>
        <source>The camera names photos as API level 1 does (&quot;%1&quot;); such cameras cannot be used yet.</source>
        <translation>Die Kamera nennt Fotos wie die API-Stufe 1 (&quot;%1&quot;); solche Kameras gehen noch nicht.</translation>
    </message>
    <message>
        <source>The camera at %1 sent %2; switch it off and on if this persists.</source>
        <translation>Die Kamera bei %1 hat %2 geschickt; schalten Sie sie aus und ein, wenn es so bleibt.</translation>
    </message>
    <message>
        <source>an empty answer</source>
        <translation>eine leere Antwort</translation>
    </message>
    <message>
        <source>an answer that is not valid JSON</source>
        <translation>eine Antwort, die kein gültiges JSON ist</translation>
    </message>
    <message>
        <source>The camera at %1 sent JSON that is not an object; update its firmware.</source>
        <translation>Die Kamera bei %1 hat JSON geschickt, das kein Objekt ist; erneuern Sie ihre Firmware.</translation>
    </message>
    <message>
        <source>The camera at %1 has sent no picture of its preview for %2 s; check the WiFi, press the camera&apos;s button in case it sleeps, and start the preview again.</source>
        <translation>Die Kamera bei %1 hat %2 s lang kein Bild der Vorschau geschickt; prüfen Sie das WLAN, drücken Sie ihre Taste, falls sie schläft, und beginnen Sie die Vorschau noch einmal.</translation>
    </message>
    <message>
        <source>A plug-in runs on the camera; end it by the camera&apos;s mode button, then resume.</source>
        <translation>Auf der Kamera läuft ein Plug-in; beenden Sie es mit ihrer Modus-Taste, und machen Sie dann weiter.</translation>
    </message>
    <message>
        <source>The camera&apos;s battery is at %1; charge it before going on.</source>
        <translation>Der Akku der Kamera steht bei %1; laden Sie ihn, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>The camera&apos;s battery is at %1; charge it soon.</source>
        <translation>Der Akku der Kamera steht bei %1; laden Sie ihn bald.</translation>
    </message>
    <message>
        <source>The camera has room for only %1 more photos.</source>
        <translation>Die Kamera hat nur noch Platz für %1 Fotos.</translation>
    </message>
    <message>
        <source>The camera&apos;s storage is full; back its photos up, free some space, and resume.</source>
        <translation>Der Speicher der Kamera ist voll; sichern Sie ihre Fotos, schaffen Sie Platz, und machen Sie weiter.</translation>
    </message>
    <message>
        <source>Another camera answers (serial number %1 instead of %2); check the WiFi, or connect anew.</source>
        <translation>Eine andere Kamera antwortet (Seriennummer %1 statt %2); prüfen Sie das WLAN, oder verbinden Sie neu.</translation>
    </message>
    <message>
        <source>Another camera answers now (serial number %1); whether the camera %2 has taken this photo must be looked up on it.</source>
        <translation>Jetzt antwortet eine andere Kamera (Seriennummer %1); ob die Kamera %2 dieses Foto gemacht hat, muss man auf ihr nachsehen.</translation>
    </message>
    <message>
        <source>The camera %1 speaks neither API level 1 nor 2; use another.</source>
        <translation>Die Kamera %1 spricht weder API-Stufe 1 noch 2; nehmen Sie eine andere.</translation>
    </message>
    <message>
        <source>The photo %1 has %2 x %3 pixels, but a spherical photo is twice as wide as high and at least %4 wide; set the camera to full-size stitched photos.</source>
        <translation>Das Foto %1 hat %2 x %3 Pixel; ein Kugelfoto ist doppelt so breit wie hoch und mindestens %4 breit. Stellen Sie die Kamera auf zusammengesetzte Fotos in voller Größe.</translation>
    </message>
    <message>
        <source>The camera has given the name %1 to another photo, so that this one is gone; take it again.</source>
        <translation>Die Kamera hat den Namen %1 einem anderen Foto gegeben, dieses ist also weg; nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The photo %1 is not a JPEG; set the camera to JPEG and take it again.</source>
        <translation>Das Foto %1 ist kein JPEG; stellen Sie die Kamera auf JPEG, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The camera stays busy (&quot;%1&quot;); end what it is doing, or switch it off and on, then resume.</source>
        <translation>Die Kamera bleibt beschäftigt (&quot;%1&quot;); beenden Sie, was sie tut, oder schalten Sie sie aus und ein, und machen Sie weiter.</translation>
    </message>
    <message>
        <source>The camera says that it is still taking the photo long after it must have been done; switch it off and on, then resume.</source>
        <translation>Die Kamera sagt, dass sie noch immer fotografiert, obwohl sie längst fertig sein müsste; schalten Sie sie aus und ein, und machen Sie weiter.</translation>
    </message>
    <message>
        <source>The camera stays busy or gives no steady answer about its files; switch it off and on, then resume.</source>
        <translation>Die Kamera bleibt beschäftigt oder antwortet widersprüchlich über ihre Dateien; schalten Sie sie aus und ein, und machen Sie weiter.</translation>
    </message>
    <message>
        <source>The camera has taken no photo; it can be taken again.</source>
        <translation>Die Kamera hat kein Foto gemacht; es kann neu aufgenommen werden.</translation>
    </message>
    <message>
        <source>The camera says that it has taken the photo, but has no new file: its files were deleted, or their names begin anew.</source>
        <translation>Die Kamera sagt, dass sie das Foto gemacht hat, hat aber keine neue Datei: ihre Dateien wurden gelöscht, oder ihre Namen beginnen von vorn.</translation>
    </message>
    <message>
        <source>The camera started a session without a name; switch it off and on.</source>
        <translation>Die Kamera hat eine Sitzung ohne Namen begonnen; schalten Sie sie aus und ein.</translation>
    </message>
    <message>
        <source>The camera stays at API level 1 although it offers level 2; switch it off and on.</source>
        <translation>Die Kamera bleibt bei API-Stufe 1, obwohl sie Stufe 2 anbietet; schalten Sie sie aus und ein.</translation>
    </message>
    <message>
        <source>The camera takes no photos %1 pixels wide, but %2.</source>
        <translation>Die Kamera macht keine %1 Pixel breiten Fotos, sondern %2.</translation>
    </message>
    <message>
        <source>Change the survey&apos;s capture profile.</source>
        <translation>Ändern Sie die Belichtung des Projekts.</translation>
    </message>
    <message>
        <source>The camera does not offer the white balance %1.</source>
        <translation>Die Kamera hat den Weißabgleich %1 nicht.</translation>
    </message>
    <message>
        <source>The camera does not offer the %1 %2; the nearest are %3.</source>
        <translation>Die Kamera hat %1 %2 nicht; am nächsten sind %3.</translation>
    </message>
    <message>
        <source>The camera stays in the mode &quot;%1&quot;; set it to still pictures by its mode button.</source>
        <translation>Die Kamera bleibt in der Betriebsart &quot;%1&quot;; stellen Sie sie mit ihrer Modus-Taste auf Einzelbilder.</translation>
    </message>
    <message>
        <source>The camera does not take spherical JPEGs twice as wide as high; set it to stitched JPEG photos.</source>
        <translation>Die Kamera macht keine Kugelfotos als JPEG, doppelt so breit wie hoch; stellen Sie sie auf zusammengesetzte JPEG-Fotos.</translation>
    </message>
    <message>
        <source>The camera could not be told that it may sleep again; switch it off and on if it is not used soon.</source>
        <translation>Der Kamera war nicht mehr zu sagen, dass sie wieder schlafen darf; schalten Sie sie aus und ein, wenn sie nicht bald gebraucht wird.</translation>
    </message>
    <message>
        <source>The downloaded photo changed on the disk before it was recorded; the next run downloads it again.</source>
        <translation>Das geladene Foto hat sich auf der Platte geändert, bevor es eingetragen war; der nächste Lauf lädt es noch einmal.</translation>
    </message>
    <message>
        <source>The photo of %1 is not known to be its own any more; take it again.</source>
        <translation>Es ist nicht mehr bekannt, ob das Foto von %1 sein eigenes ist; nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The camera refused to %1: %2.</source>
        <translation>Die Kamera hat etwas abgelehnt (%1): %2.</translation>
    </message>
    <message>
        <source>this camera cannot do it; update its firmware or use another camera</source>
        <translation>diese Kamera kann es nicht; erneuern Sie ihre Firmware, oder nehmen Sie eine andere Kamera</translation>
    </message>
    <message>
        <source>set the camera to still pictures, end its plug-in or preview, close the telephone&apos;s application, and try again</source>
        <translation>stellen Sie die Kamera auf Einzelbilder, beenden Sie ihr Plug-in oder ihre Vorschau, schließen Sie das Programm auf dem Telefon, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>the camera does not allow this value in its present mode</source>
        <translation>die Kamera erlaubt diesen Wert in ihrer jetzigen Betriebsart nicht</translation>
    </message>
    <message>
        <source>the file is damaged on the camera; take the photo again</source>
        <translation>die Datei ist auf der Kamera beschädigt; nehmen Sie das Foto neu auf</translation>
    </message>
    <message>
        <source>the camera is switching off; switch it on and resume</source>
        <translation>die Kamera schaltet sich aus; schalten Sie sie ein, und machen Sie weiter</translation>
    </message>
    <message>
        <source>wait a moment and try again</source>
        <translation>warten Sie einen Augenblick, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>switch the camera off and on, then resume</source>
        <translation>schalten Sie die Kamera aus und ein, und machen Sie weiter</translation>
    </message>
    <message>
        <source>the shot was cancelled at the camera; take it again</source>
        <translation>die Aufnahme wurde an der Kamera abgebrochen; nehmen Sie das Foto neu auf</translation>
    </message>
    <message>
        <source>check that nobody has deleted the file from the camera</source>
        <translation>prüfen Sie, ob jemand die Datei auf der Kamera gelöscht hat</translation>
    </message>
    <message>
        <source>the camera has ended the session; switch it off and on, and close the telephone&apos;s application</source>
        <translation>die Kamera hat die Sitzung beendet; schalten Sie sie aus und ein, und schließen Sie das Programm auf dem Telefon</translation>
    </message>
    <message>
        <source>close the other program or telephone that uses the camera; if none does, wait three minutes</source>
        <translation>schließen Sie das Programm oder Telefon, das die Kamera benutzt; tut es keines, warten Sie drei Minuten</translation>
    </message>
    <message>
        <source>the camera&apos;s storage is full; back its photos up and free some space</source>
        <translation>der Speicher der Kamera ist voll; sichern Sie ihre Fotos, und schaffen Sie Platz</translation>
    </message>
    <message>
        <source>it asks for a user name and a password (client mode), and was given none or wrong ones; give the right ones, or use the camera&apos;s own WiFi</source>
        <translation>sie verlangt Benutzername und Kennwort (Client-Modus) und hat keine oder falsche bekommen; geben Sie die richtigen an, oder benutzen Sie das WLAN der Kamera</translation>
    </message>
    <message>
        <source>update the camera&apos;s firmware; if it stays so, report it</source>
        <translation>erneuern Sie die Firmware der Kamera; bleibt es so, melden Sie es</translation>
    </message>
    <message>
        <source>The photo %1 is not usable: %2; %3.</source>
        <translation>Das Foto %1 ist nicht zu gebrauchen: %2; %3.</translation>
    </message>
    <message>
        <source>fetch it from the camera again</source>
        <translation>holen Sie es noch einmal von der Kamera</translation>
    </message>
    <message>
        <source>it has %1 bytes instead of %2</source>
        <translation>es hat %1 Bytes statt %2</translation>
    </message>
    <message>
        <source>it is not a JPEG</source>
        <translation>es ist kein JPEG</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>sein Ende fehlt</translation>
    </message>
    <message>
        <source>its bytes are not those that were recorded (the SHA-256 differs)</source>
        <translation>seine Bytes sind nicht die eingetragenen (die SHA-256 ist eine andere)</translation>
    </message>
    <message>
        <source>it is not spherical, its %1 pixels are not twice as wide as high</source>
        <translation>es ist keine Kugel, seine %1 Pixel sind nicht doppelt so breit wie hoch</translation>
    </message>
    <message>
        <source>take or export it as a whole stitched sphere</source>
        <translation>machen oder exportieren Sie es als ganze zusammengesetzte Kugel</translation>
    </message>
    <message>
        <source>it is only %1 pixels wide, as a preview is; at least %2 are needed</source>
        <translation>es ist nur %1 Pixel breit wie eine Vorschau; mindestens %2 sind nötig</translation>
    </message>
    <message>
        <source>The photo %1 is in the survey already, as %2.</source>
        <translation>Das Foto %1 ist schon im Projekt, als %2.</translation>
    </message>
    <message>
        <source>The picture %1 has %2 x %3 pixels, not the camera&apos;s %4 x %5.</source>
        <translation>Das Bild %1 hat %2 x %3 Pixel, nicht die %4 x %5 der Kamera.</translation>
    </message>
    <message>
        <source>%1 is in the survey already, as %2 at %3, %4 m from the place in the file.</source>
        <translation>%1 ist schon im Projekt, als %2 bei %3, %4 m vom Ort in der Datei.</translation>
    </message>
    <message>
        <source>%1 photos stand outside of the room&apos;s outline; check the outline and the positions.</source>
        <translation>%1 Fotos stehen außerhalb des Grundrisses; prüfen Sie Grundriss und Positionen.</translation>
    </message>
    <message>
        <source>Could not read the positions %1: %2.</source>
        <translation>Die Positionen %1 waren nicht zu lesen: %2.</translation>
    </message>
    <message>
        <source>Could not read %1: there is no such file or folder.</source>
        <translation>%1 war nicht zu lesen: es gibt keine solche Datei.</translation>
    </message>
    <message>
        <source>Could not write %1: there is no such file or folder.</source>
        <translation>%1 war nicht zu schreiben: es gibt keinen solchen Ordner.</translation>
    </message>
    <message>
        <source>Could not read %1: %2; check the permissions.</source>
        <translation>%1 war nicht zu lesen: %2; prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>Could not write %1: %2; check the permissions.</source>
        <translation>%1 war nicht zu schreiben: %2; prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>Could not write %1: the disk is full; free some space and try again.</source>
        <translation>%1 war nicht zu schreiben: die Platte ist voll; schaffen Sie Platz, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Could not write %1: it exists already.</source>
        <translation>%1 war nicht zu schreiben: es gibt das schon.</translation>
    </message>
    <message>
        <source>Could not write %1; is the disk full?</source>
        <translation>%1 war nicht zu schreiben; ist die Platte voll?</translation>
    </message>
    <message>
        <source>Could not write %1 %2: it exists already; choose another name, or remove it first.</source>
        <translation>%1 %2 war nicht zu schreiben: es gibt das schon; nehmen Sie einen anderen Namen, oder löschen Sie es zuerst.</translation>
    </message>
    <message>
        <source>Could not read %1: it is not a file.</source>
        <translation>%1 war nicht zu lesen: es ist keine Datei.</translation>
    </message>
    <message>
        <source>Could not read %1: it ends too early; copy the file again.</source>
        <translation>%1 war nicht zu lesen: es endet zu früh; kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Could not read %1: it has %2, more than the %3 that such a file may have.</source>
        <translation>%1 war nicht zu lesen: es hat %2, mehr als die %3, die eine solche Datei haben darf.</translation>
    </message>
    <message>
        <source>Could not read %1: it is not valid JSON.</source>
        <translation>%1 war nicht zu lesen: es ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Could not read %1: it is neither a PNG nor a JPEG.</source>
        <translation>%1 war nicht zu lesen: es ist weder PNG noch JPEG.</translation>
    </message>
    <message>
        <source>Could not read %1: the PNG is damaged, copy it again.</source>
        <translation>%1 war nicht zu lesen: das PNG ist beschädigt, kopieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Could not make the folder %1: %2.</source>
        <translation>Der Ordner %1 war nicht anzulegen: %2.</translation>
    </message>
    <message>
        <source>Could not make a temporary folder %1: %2; set TMPDIR to a folder that can be written.</source>
        <translation>Ein Ordner auf Zeit, %1, war nicht anzulegen: %2; setzen Sie TMPDIR auf einen Ordner, in den man schreiben kann.</translation>
    </message>
    <message>
        <source>Stopped on request; what was complete is kept.</source>
        <translation>Auf Wunsch angehalten; was fertig war, bleibt.</translation>
    </message>
    <message>
        <source>%1 is not a survey: %2; give a folder that Spherewalk has made.</source>
        <translation>%1 ist kein Projekt: %2; nehmen Sie einen Ordner, den Spherewalk gemacht hat.</translation>
    </message>
    <message>
        <source>There is no survey %1; check the path.</source>
        <translation>Es gibt kein Projekt %1; prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>Could not open the survey %1: %2.</source>
        <translation>Das Projekt %1 war nicht zu öffnen: %2.</translation>
    </message>
    <message>
        <source>The survey&apos;s database %1 is empty.</source>
        <translation>Die Datenbank des Projekts, %1, ist leer.</translation>
    </message>
    <message>
        <source>The survey&apos;s database %1 is damaged: %2.</source>
        <translation>Die Datenbank des Projekts, %1, ist beschädigt: %2.</translation>
    </message>
    <message>
        <source>Restore it from a copy; the photos beside it are not affected.</source>
        <translation>Stellen Sie sie aus einer Kopie wieder her; die Fotos daneben sind nicht betroffen.</translation>
    </message>
    <message>
        <source>The survey %1 was written by a newer Spherewalk (format %2, this one knows up to %3); update Spherewalk to open it.</source>
        <translation>Das Projekt %1 hat ein neueres Spherewalk geschrieben (Format %2, dieses kennt bis %3); erneuern Sie Spherewalk, um es zu öffnen.</translation>
    </message>
    <message>
        <source>Could not create the survey %1: there is something by that name already; open it, or choose another name.</source>
        <translation>Das Projekt %1 war nicht anzulegen: es gibt schon etwas dieses Namens; öffnen Sie es, oder nehmen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Could not create the survey %1: %2.</source>
        <translation>Das Projekt %1 war nicht anzulegen: %2.</translation>
    </message>
    <message>
        <source>Could not create the folder %1: %2.</source>
        <translation>Der Ordner %1 war nicht anzulegen: %2.</translation>
    </message>
    <message>
        <source>Could not change the survey %1: it is open for reading only.</source>
        <translation>Das Projekt %1 war nicht zu ändern: es ist nur zum Lesen offen.</translation>
    </message>
    <message>
        <source>The survey %1 is being written by another program%2; close it there, or open it here for reading.</source>
        <translation>Das Projekt %1 wird von einem anderen Programm geschrieben%2; schließen Sie es dort, oder öffnen Sie es hier zum Lesen.</translation>
    </message>
    <message>
        <source>The survey %1 is being written by another program; close it there, or open it here for reading.</source>
        <translation>Das Projekt %1 wird von einem anderen Programm geschrieben; schließen Sie es dort, oder öffnen Sie es hier zum Lesen.</translation>
    </message>
    <message>
        <source>Could not open the survey %1 for writing: %2; check the permissions, or open it for reading.</source>
        <translation>Das Projekt %1 war nicht zum Schreiben zu öffnen: %2; prüfen Sie die Rechte, oder öffnen Sie es zum Lesen.</translation>
    </message>
    <message>
        <source>Could not lock the survey %1 for writing: %2.</source>
        <translation>Das Projekt %1 war nicht zum Schreiben zu sperren: %2.</translation>
    </message>
    <message>
        <source>Could not replace the plan of the survey %1: photos have been taken at its stations; create another survey for the new plan.</source>
        <translation>Der Plan des Projekts %1 war nicht zu ersetzen: an seinen Stationen wurden Fotos gemacht; legen Sie für den neuen Plan ein anderes Projekt an.</translation>
    </message>
    <message>
        <source>The outline cannot be used: %1.</source>
        <translation>Der Grundriss ist nicht zu gebrauchen: %1.</translation>
    </message>
    <message>
        <source>The obstacle %1 cannot be used: %2.</source>
        <translation>Das Hindernis %1 ist nicht zu gebrauchen: %2.</translation>
    </message>
    <message>
        <source>the wall after corner %1 crosses the wall after corner %2</source>
        <translation>die Wand nach Ecke %1 kreuzt die Wand nach Ecke %2</translation>
    </message>
    <message>
        <source>corners %1 and %2 are the same point</source>
        <translation>die Ecken %1 und %2 sind derselbe Punkt</translation>
    </message>
    <message>
        <source>at corner %1 it turns back on itself</source>
        <translation>an der Ecke %1 kehrt er auf sich selbst zurück</translation>
    </message>
    <message>
        <source>it has %1 corners, and needs at least three</source>
        <translation>er hat %1 Ecken und braucht mindestens drei</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>eine Koordinate ist keine Zahl</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>er hat keine Fläche</translation>
    </message>
    <message>
        <source>The outline is %1 m long, more than the %2 m that one survey may have; check its unit (metres), or split the room.</source>
        <translation>Der Grundriss ist %1 m lang, mehr als die %2 m, die ein Projekt haben darf; prüfen Sie die Einheit (Meter), oder teilen Sie den Raum.</translation>
    </message>
    <message>
        <source>The room has %1 corners, more than the %2 allowed; draw it more simply.</source>
        <translation>Der Raum hat %1 Ecken, mehr als die erlaubten %2; zeichnen Sie ihn einfacher.</translation>
    </message>
    <message>
        <source>The obstacle %1 lies outside the outline; move it into the room or remove it.</source>
        <translation>Das Hindernis %1 liegt außerhalb des Grundrisses; schieben Sie es in den Raum, oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>The ceiling cannot be at %1 m: give its height above the floor, up to %2 m.</source>
        <translation>Die Decke kann nicht bei %1 m sein: geben Sie ihre Höhe über dem Boden an, bis %2 m.</translation>
    </message>
    <message>
        <source>A plan needs from one to %1 heights of the lens, not %2.</source>
        <translation>Ein Plan braucht eine bis %1 Höhen des Objektivs, nicht %2.</translation>
    </message>
    <message>
        <source>The lens cannot be at %1 m: give heights above the floor and below the ceiling, which is at %2 m.</source>
        <translation>Das Objektiv kann nicht bei %1 m sein: geben Sie Höhen über dem Boden und unter der Decke an, die bei %2 m ist.</translation>
    </message>
    <message>
        <source>The height of %1 m is listed twice; list each height once.</source>
        <translation>Die Höhe %1 m steht zweimal da; geben Sie jede Höhe einmal an.</translation>
    </message>
    <message>
        <source>A step of %1 m is too fine for this room: %2.</source>
        <translation>Ein Schritt von %1 m ist zu fein für diesen Raum: %2.</translation>
    </message>
    <message>
        <source>A step of %1 m fits.</source>
        <translation>Ein Schritt von %1 m passt.</translation>
    </message>
    <message>
        <source>it would take %1 stations, more than the %2 of one plan</source>
        <translation>er brauchte %1 Stationen, mehr als die %2 eines Plans</translation>
    </message>
    <message>
        <source>its bounds would hold more than %1 stops</source>
        <translation>seine Grenzen fassten mehr als %1 Halte</translation>
    </message>
    <message>
        <source>There is nothing to align in %1: no station has a photo yet; capture or import some first.</source>
        <translation>In %1 gibt es nichts auszurichten: noch keine Station hat ein Foto; nehmen Sie erst welche auf, oder importieren Sie sie.</translation>
    </message>
    <message>
        <source>No photo could be aligned, so no solution was recorded; see what is said of each photo.</source>
        <translation>Kein Foto war auszurichten, deshalb wurde keine Lösung eingetragen; sehen Sie nach, was zu jedem Foto gesagt wird.</translation>
    </message>
    <message>
        <source>The photos do not show where walls, floor and ceiling are, and no room is drawn: the dataset has no room.</source>
        <translation>Die Fotos zeigen nicht, wo Wände, Boden und Decke sind, und es ist kein Raum gezeichnet: der Datensatz hat keinen Raum.</translation>
    </message>
    <message>
        <source>The photos do not show where walls, floor and ceiling are: the dataset&apos;s room is the drawn one.</source>
        <translation>Die Fotos zeigen nicht, wo Wände, Boden und Decke sind: der Raum des Datensatzes ist der gezeichnete.</translation>
    </message>
    <message>
        <source>Nothing can be exported.</source>
        <translation>Nichts kann exportiert werden.</translation>
    </message>
    <message>
        <source>The heading of %1 of %2 photos is not known; they are exported as if each looked along the room&apos;s x axis.</source>
        <translation>Die Richtung von %1 der %2 Fotos ist nicht bekannt; sie werden exportiert, als blickten sie entlang der x-Achse des Raums.</translation>
    </message>
    <message>
        <source>Could not keep a copy of the database as %1: %2.</source>
        <translation>Eine Kopie der Datenbank war nicht als %1 abzulegen: %2.</translation>
    </message>
    <message>
        <source>The camera refused to %1 (&quot;%2&quot;): %3.</source>
        <translation>Die Kamera hat etwas abgelehnt (%1, &quot;%2&quot;): %3.</translation>
    </message>
    <message>
        <source>take the photo</source>
        <translation>das Foto aufnehmen</translation>
    </message>
    <message>
        <source>list its files</source>
        <translation>ihre Dateien auflisten</translation>
    </message>
    <message>
        <source>describe itself</source>
        <translation>sich beschreiben</translation>
    </message>
    <message>
        <source>show its preview</source>
        <translation>ihre Vorschau zeigen</translation>
    </message>
    <message>
        <source>speak API level 2</source>
        <translation>API-Stufe 2 sprechen</translation>
    </message>
    <message>
        <source>start a session</source>
        <translation>eine Sitzung beginnen</translation>
    </message>
    <message>
        <source>tell its settings</source>
        <translation>ihre Einstellungen nennen</translation>
    </message>
    <message>
        <source>change its settings</source>
        <translation>ihre Einstellungen ändern</translation>
    </message>
    <message>
        <source>tell its state</source>
        <translation>ihren Zustand nennen</translation>
    </message>
    <message>
        <source>The room &quot;%1&quot; lies outside the outline; move its name into the room or remove it.</source>
        <translation>Der Raum &quot;%1&quot; liegt außerhalb des Grundrisses; schreiben Sie seinen Namen in den Raum, oder entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>A room cannot be called &quot;%1&quot;: give one line of up to %2 letters.</source>
        <translation>Ein Raum kann nicht &quot;%1&quot; heißen: geben Sie eine Zeile von bis zu %2 Buchstaben an.</translation>
    </message>
    <message>
        <source>The plan names %1 rooms, more than the %2 allowed.</source>
        <translation>Der Plan benennt %1 Räume, mehr als die erlaubten %2.</translation>
    </message>
    <message>
        <source>Rail %1 cannot lie there: it leaves the floor, or meets a wall or an obstacle; move it, or make it shorter.</source>
        <translation>Schiene %1 kann dort nicht liegen: sie verlässt den Boden oder trifft auf eine Wand oder ein Hindernis; verschieben oder kürzen Sie sie.</translation>
    </message>
    <message>
        <source>Rails %1 and %2 have a stop at the same place; move one of them.</source>
        <translation>Die Schienen %1 und %2 haben einen Halt an derselben Stelle; verschieben Sie eine davon.</translation>
    </message>
    <message>
        <source>Could not read %1: it has no faces (lines &quot;f 1 2 3&quot;); export the mesh as OBJ.</source>
        <translation>%1 konnte nicht gelesen werden: es hat keine Flächen (Zeilen „f 1 2 3“); exportieren Sie das Netz als OBJ.</translation>
    </message>
    <message>
        <source>Could not read %1: a face names vertex %2 of %3; export the mesh again.</source>
        <translation>%1 konnte nicht gelesen werden: eine Fläche nennt Ecke %2 von %3; exportieren Sie das Netz erneut.</translation>
    </message>
    <message>
        <source>Could not read %1: all of its points are the same; export the mesh again.</source>
        <translation>%1 konnte nicht gelesen werden: alle Punkte sind gleich; exportieren Sie das Netz erneut.</translation>
    </message>
    <message>
        <source>Could not read %1: line %2 is no vertex (&quot;v x y z&quot;); export the mesh again.</source>
        <translation>%1 konnte nicht gelesen werden: Zeile %2 ist keine Ecke („v x y z“); exportieren Sie das Netz erneut.</translation>
    </message>
    <message>
        <source>Could not read %1: line %2 is no face (&quot;f 1 2 3&quot;); export the mesh again.</source>
        <translation>%1 konnte nicht gelesen werden: Zeile %2 ist keine Fläche („f 1 2 3“); exportieren Sie das Netz erneut.</translation>
    </message>
    <message>
        <source>Could not read %1: it has more than %2 triangles; make it simpler.</source>
        <translation>%1 konnte nicht gelesen werden: es hat mehr als %2 Dreiecke; vereinfachen Sie es.</translation>
    </message>
    <message>
        <source>No photo is left to export; capture some first, or accept some.</source>
        <translation>Kein Foto ist zum Exportieren übrig; nehmen Sie erst welche auf, oder nehmen Sie welche an.</translation>
    </message>
    <message>
        <source>How much space is left at %1 cannot be told.</source>
        <translation>Wie viel Platz bei %1 frei ist, lässt sich nicht sagen.</translation>
    </message>
    <message>
        <source>The dataset needs about %1, and %2 are free at %3; make space, or choose another place.</source>
        <translation>Der Datensatz braucht etwa %1, und bei %3 sind %2 frei; schaffen Sie Platz, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The survey is not aligned: photos would be exported as if each looked along the room&apos;s x axis; align it first.</source>
        <translation>Das Projekt ist nicht ausgerichtet: Fotos würden exportiert, als blickte jedes entlang der x-Achse des Raums; richten Sie es erst aus.</translation>
    </message>
    <message>
        <source>1 photo has no known heading: it would be exported as if it looked along the room&apos;s x axis; align again, or reject it.</source>
        <translation>1 Foto hat keine bekannte Richtung: es würde exportiert, als blickte es entlang der x-Achse des Raums; richten Sie erneut aus, oder weisen Sie es zurück.</translation>
    </message>
    <message>
        <source>No other photo shares enough with it that a third one confirms: it seems to be of another place.</source>
        <translation>Kein anderes Foto hat genug mit ihm gemeinsam, das ein drittes bestätigt: es scheint von einem anderen Ort zu sein.</translation>
    </message>
    <message>
        <source>Leave it out, or take photos between it and the others.</source>
        <translation>Lassen Sie es weg, oder nehmen Sie Fotos zwischen ihm und den anderen auf.</translation>
    </message>
    <message>
        <source>It was taken at one place with the others, so nothing tells how far things are: take others half a metre from it.</source>
        <translation>Es wurde am selben Ort wie die anderen aufgenommen, daher verrät nichts, wie weit die Dinge entfernt sind: Nehmen Sie weitere einen halben Meter neben ihm auf.</translation>
    </message>
    <message>
        <source>Take photos between them.</source>
        <translation>Nehmen Sie Fotos dazwischen auf.</translation>
    </message>
    <message>
        <source>The other photo shares too little with it: it seems to be of another place.</source>
        <translation>Das andere Foto hat zu wenig mit ihm gemeinsam: es scheint von einem anderen Ort zu sein.</translation>
    </message>
    <message>
        <source>It is the only photo, and nothing tells how far things are: take others half a metre from it.</source>
        <translation>Es ist das einzige Foto, und nichts verrät, wie weit die Dinge entfernt sind: Nehmen Sie weitere einen halben Meter neben ihm auf.</translation>
    </message>
    <message>
        <source>It belongs to part %1 of %2, which shares nothing certain with the largest part: take photos between the parts.</source>
        <translation>Es gehört zu Teil %1 von %2, der nichts Sicheres mit dem größten Teil gemeinsam hat: nehmen Sie Fotos zwischen den Teilen auf.</translation>
    </message>
    <message>
        <source>How far it is from the others is not known: it shares too little with two of them at a time.</source>
        <translation>Wie weit es von den anderen entfernt ist, ist nicht bekannt: es hat zu wenig mit je zweien von ihnen gemeinsam.</translation>
    </message>
    <message>
        <source>Take another photo near it.</source>
        <translation>Nehmen Sie ein weiteres Foto in seiner Nähe auf.</translation>
    </message>
    <message>
        <source>Little confirms where it was taken: it shares %1 points with %2 other photos.</source>
        <translation>Wenig bestätigt, wo es aufgenommen wurde: es hat %1 Punkte mit %2 anderen Fotos gemeinsam.</translation>
    </message>
    <message>
        <source>Where it was taken is known to %1 cm and %2 deg only: take another photo near it.</source>
        <translation>Wo es aufgenommen wurde, ist nur auf %1 cm und %2 Grad bekannt: nehmen Sie ein weiteres Foto in seiner Nähe auf.</translation>
    </message>
    <message>
        <source>Two ways of solving turn it %1 deg apart: take another photo near it.</source>
        <translation>Zwei Lösungswege drehen es um %1 Grad verschieden: nehmen Sie ein weiteres Foto in seiner Nähe auf.</translation>
    </message>
    <message>
        <source>It shows some things that the largest part shows, but not what stands around them: it seems to be of another place that looks alike.</source>
        <translation>Es zeigt einiges, was auch der größte Teil zeigt, aber nicht, was darum herum steht: es scheint von einem anderen Ort zu sein, der ähnlich aussieht.</translation>
    </message>
    <message>
        <source>Little of what the largest part lets expect around it is there, so how it stands to the others is not certain: take photos between it and them.</source>
        <translation>Von dem, was der größte Teil um es herum erwarten lässt, ist wenig da, daher ist nicht sicher, wie es zu den anderen steht: nehmen Sie Fotos zwischen ihm und ihnen auf.</translation>
    </message>
    <message>
        <source>The floor around it lies %1 cm above that of the largest part: if there is no step, lengths around it are %2 % too short.</source>
        <translation>Der Boden um es herum liegt %1 cm über dem des größten Teils: wenn dort keine Stufe ist, sind die Längen um es herum %2 % zu kurz.</translation>
    </message>
    <message>
        <source>The floor around it lies %1 cm below that of the largest part: if there is no step, lengths around it are %2 % too long.</source>
        <translation>Der Boden um es herum liegt %1 cm unter dem des größten Teils: wenn dort keine Stufe ist, sind die Längen um es herum %2 % zu lang.</translation>
    </message>
    <message>
        <source>Take photos between it and the others.</source>
        <translation>Nehmen Sie Fotos zwischen ihm und den anderen auf.</translation>
    </message>
    <message>
        <source>Looking for faces in photo %1 of %2</source>
        <translation>Sucht Gesichter in Foto %1 von %2</translation>
    </message>
    <message>
        <source>Faces cannot be looked for: there is no file %1.</source>
        <translation>Gesichter können nicht gesucht werden: Es gibt keine Datei %1.</translation>
    </message>
    <message>
        <source>Install the package opencv-data, or mark the regions yourself.</source>
        <translation>Installieren Sie das Paket opencv-data, oder markieren Sie die Bereiche selbst.</translation>
    </message>
    <message>
        <source>The file %1 is no cascade.</source>
        <translation>Die Datei %1 ist keine Kaskade.</translation>
    </message>
    <message>
        <source>The survey&apos;s disk has room for about %1 of the %2 photos that are still to be taken; make space before you go on.</source>
        <translation>Auf dem Datenträger des Projekts ist Platz für etwa %1 der %2 Fotos, die noch aufzunehmen sind; schaffen Sie Platz, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the scene model %3, reaches %4 px.</source>
        <translation>Keine der untersuchten Schrittweiten hält %1 px an 95 von 100 Stellen; die beste, %2 cm mit dem Szenenmodell %3, erreicht %4 px.</translation>
    </message>
    <message>
        <source>None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the scene model %3, misses more than 5 of 100 places.</source>
        <translation>Keine der untersuchten Schrittweiten hält %1 px an 95 von 100 Stellen; die beste, %2 cm mit dem Szenenmodell %3, verfehlt mehr als 5 von 100 Stellen.</translation>
    </message>
    <message>
        <source>Study a denser block, or allow more.</source>
        <translation>Untersuchen Sie einen dichteren Block, oder erlauben Sie mehr.</translation>
    </message>
    <message>
        <source>For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3 (no coarser one was studied): %4 photos, about %5.</source>
        <translation>Für %1 px an 95 von 100 Stellen genügt ein Raster von %2 cm mit dem Szenenmodell %3 (ein gröberes wurde nicht untersucht): %4 Fotos, etwa %5.</translation>
    </message>
    <message>
        <source>For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3: %4 photos, about %5.</source>
        <translation>Für %1 px an 95 von 100 Stellen genügt ein Raster von %2 cm mit dem Szenenmodell %3: %4 Fotos, etwa %5.</translation>
    </message>
    <message>
        <source>Looking for features</source>
        <translation>Merkmale werden gesucht</translation>
    </message>
    <message>
        <source>Matching photos</source>
        <translation>Fotos werden zugeordnet</translation>
    </message>
    <message>
        <source>Looking for AprilTags</source>
        <translation>AprilTags werden gesucht</translation>
    </message>
    <message>
        <source>Looking for photos that look alike</source>
        <translation>Ähnliche Fotos werden gesucht</translation>
    </message>
    <message>
        <source>Averaging rotations</source>
        <translation>Drehungen werden gemittelt</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Ausgleichung läuft</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Orte gefunden</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Ausgerichtet</translation>
    </message>
    <message>
        <source>Reading what the photos say</source>
        <translation>Angaben der Fotos werden gelesen</translation>
    </message>
    <message>
        <source>Estimating how neighbours are turned to each other</source>
        <translation>Drehungen zwischen Nachbarn werden geschätzt</translation>
    </message>
    <message>
        <source>Checking the positions</source>
        <translation>Positionen werden geprüft</translation>
    </message>
    <message>
        <source>Looking for what moved</source>
        <translation>Bewegtes wird gesucht</translation>
    </message>
    <message>
        <source>Looking for what stands where other photos look through</source>
        <translation>Gesucht wird, was dort steht, wo andere Fotos hindurchsehen</translation>
    </message>
    <message>
        <source>Writing the photos&apos; position tags</source>
        <translation>Positionen werden in die Fotos geschrieben</translation>
    </message>
    <message>
        <source>Retagged</source>
        <translation>Neu zugeordnet</translation>
    </message>
    <message>
        <source>Photo %1 of %2, %3</source>
        <translation>Foto %1 von %2, %3</translation>
    </message>
    <message>
        <source>Judging photo %1 of %2</source>
        <translation>Foto %1 von %2 wird beurteilt</translation>
    </message>
    <message>
        <source>Importing photo %1 of %2</source>
        <translation>Foto %1 von %2 wird importiert</translation>
    </message>
    <message>
        <source>Looking at the place of %1</source>
        <translation>Der Ort von %1 wird geprüft</translation>
    </message>
    <message>
        <source>Looked at all places</source>
        <translation>Alle Orte sind geprüft</translation>
    </message>
    <message>
        <source>Writing photo %1 of %2</source>
        <translation>Foto %1 von %2 wird geschrieben</translation>
    </message>
    <message>
        <source>Estimating depth, photo %1 of %2</source>
        <translation>Tiefe wird geschätzt, Foto %1 von %2</translation>
    </message>
    <message>
        <source>Clearing the floor below the camera, photo %1 of %2</source>
        <translation>Der Boden unter der Kamera wird freigelegt, Foto %1 von %2</translation>
    </message>
    <message>
        <source>Trying one photo</source>
        <translation>Ein Foto wird probiert</translation>
    </message>
    <message>
        <source>Trying one depth</source>
        <translation>Eine Tiefe wird probiert</translation>
    </message>
    <message>
        <source>Looking at the survey</source>
        <translation>Das Projekt wird durchgesehen</translation>
    </message>
    <message>
        <source>Making boxes of furniture</source>
        <translation>Quader für Möbel werden gebildet</translation>
    </message>
    <message>
        <source>Finding surfaces</source>
        <translation>Flächen werden gesucht</translation>
    </message>
    <message>
        <source>Reading depth %1 of %2</source>
        <translation>Tiefe %1 von %2 wird gelesen</translation>
    </message>
    <message>
        <source>Painting surfaces, photo %1 of %2</source>
        <translation>Flächen erhalten Farbe, Foto %1 von %2</translation>
    </message>
    <message>
        <source>Fusing depths</source>
        <translation>Tiefen werden vereinigt</translation>
    </message>
    <message>
        <source>Looking which photos see each other</source>
        <translation>Gesucht wird, welche Fotos einander sehen</translation>
    </message>
    <message>
        <source>Drawing picture %1 of %2</source>
        <translation>Bild %1 von %2 wird gezeichnet</translation>
    </message>
    <message>
        <source>Rendering the walk</source>
        <translation>Die Fahrt wird gerechnet</translation>
    </message>
    <message>
        <source>Registering picture %1 of %2 by its tags</source>
        <translation>Bild %1 von %2 wird an seinen Marken eingepasst</translation>
    </message>
    <message>
        <source>Comparing picture %1 of %2 again</source>
        <translation>Bild %1 von %2 wird noch einmal verglichen</translation>
    </message>
    <message>
        <source>Comparing picture %1 of %2</source>
        <translation>Bild %1 von %2 wird verglichen</translation>
    </message>
    <message>
        <source>Comparing border %1 of %2</source>
        <translation>Grenze %1 von %2 wird verglichen</translation>
    </message>
    <message>
        <source>Comparing view %1 of %2</source>
        <translation>Ansicht %1 von %2 wird verglichen</translation>
    </message>
    <message>
        <source>Grid of %1: comparing view %2 of %3</source>
        <translation>Raster von %1: Ansicht %2 von %3 wird verglichen</translation>
    </message>
    <message>
        <source>Comparing with the exact room</source>
        <translation>Vergleich mit dem genauen Raum</translation>
    </message>
    <message>
        <source>Timing views</source>
        <translation>Zeiten von Ansichten werden gemessen</translation>
    </message>
    <message>
        <source>Checking the dataset</source>
        <translation>Der Datensatz wird geprüft</translation>
    </message>
    <message>
        <source>Checking the database</source>
        <translation>Die Datenbank wird geprüft</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>rail %1, stop %2</source>
        <translation>Schiene %1, Halt %2</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>%1 wird geprüft</translation>
    </message>
    <message>
        <source>Foretelling how far views are off</source>
        <translation>Die Fehler der Ansichten werden vorhergesagt</translation>
    </message>
    <message>
        <source>Most of what the photos show stands more than half a metre beyond the drawn outline, which is too small or of another room: the dataset has the room that the photos show.</source>
        <translation>Das meiste von dem, was die Fotos zeigen, steht mehr als einen halben Meter außerhalb des gezeichneten Umrisses; er ist zu klein oder gehört zu einem anderen Raum: der Datensatz hat den Raum, den die Fotos zeigen.</translation>
    </message>
    <message>
        <source>The places were solved from the pictures.</source>
        <translation>Die Orte wurden aus den Bildern berechnet.</translation>
    </message>
    <message>
        <source>The height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one standard deviation).</source>
        <translation>Den Maßstab gibt die Höhe des Objektivs über dem berechneten Boden, %1 m, auf %2 % genau (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>A guessed height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one standard deviation).</source>
        <translation>Den Maßstab gibt eine geratene Höhe des Objektivs über dem berechneten Boden, %1 m, auf %2 % genau (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>The scale is known to %1 % (one standard deviation).</source>
        <translation>Der Maßstab ist auf %1 % bekannt (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>The given distance gives the scale, to %1 % (one standard deviation).</source>
        <translation>Den Maßstab gibt der angegebene Abstand, auf %1 % genau (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>The printed size of the tags gives the scale, to %1 % (one standard deviation).</source>
        <translation>Den Maßstab gibt die gedruckte Größe der Marken, auf %1 % genau (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>Nothing gives the scale.</source>
        <translation>Nichts gibt den Maßstab.</translation>
    </message>
    <message>
        <source>Where the photos were taken is not known yet.</source>
        <translation>Wo die Fotos aufgenommen wurden, ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Of the last photo: %1</source>
        <translation>Zum letzten Foto: %1</translation>
    </message>
    <message>
        <source>The position tags are stated to be too rough for any other.</source>
        <translation>Die Ortsangaben gelten als zu ungenau für jedes andere.</translation>
    </message>
    <message>
        <source>What its neighbours see there stands about %1 degrees away in this photo: it moved.</source>
        <translation>Was die Nachbarn dort sehen, steht in diesem Foto etwa %1 Grad daneben: Es wurde bewegt.</translation>
    </message>
    <message>
        <source>What its neighbours see there is not in this photo: it moved, vanished or is covered.</source>
        <translation>Was die Nachbarn dort sehen, fehlt in diesem Foto: Es wurde bewegt, ist verschwunden oder verdeckt.</translation>
    </message>
    <message>
        <source>one stop farther along its rail than its tag says</source>
        <translation>einen Halt weiter auf der Schiene, als angegeben ist</translation>
    </message>
    <message>
        <source>one stop before the one that its tag says</source>
        <translation>einen Halt vor dem, der angegeben ist</translation>
    </message>
    <message>
        <source>It is one of %1 photos taken %2: it shows what is seen from %3.</source>
        <translation>Es ist eines von %1 Fotos, die so aufgenommen wurden: %2. Es zeigt, was man von %3 aus sieht.</translation>
    </message>
    <message>
        <source>It was taken about %1 m from where its tag says, where no photo is planned: one stop off the end of its rail.</source>
        <translation>Es wurde etwa %1 m neben der angegebenen Stelle aufgenommen, wo kein Foto geplant ist: einen Halt über das Ende der Schiene hinaus.</translation>
    </message>
    <message>
        <source>It was taken about %1 m from where its tag says, where no photo is planned.</source>
        <translation>Es wurde etwa %1 m neben der angegebenen Stelle aufgenommen, wo kein Foto geplant ist.</translation>
    </message>
    <message>
        <source>It was taken %1: it shows what is seen from %2.</source>
        <translation>So wurde es aufgenommen: %1. Es zeigt, was man von %2 aus sieht.</translation>
    </message>
    <message>
        <source>Its rail was walked from the other end: it shows what is seen from %1.</source>
        <translation>Die Schiene wurde vom anderen Ende her abgefahren: Es zeigt, was man von %1 aus sieht.</translation>
    </message>
    <message>
        <source>It shows what is seen from %1; the photo tagged so shows %2: they are swapped.</source>
        <translation>Es zeigt, was man von %1 aus sieht; das dort angegebene Foto zeigt %2: Sie sind vertauscht.</translation>
    </message>
    <message>
        <source>It shows what is seen from %1.</source>
        <translation>Es zeigt, was man von %1 aus sieht.</translation>
    </message>
    <message>
        <source>It would lean by %1 deg from what its camera states of its tilt.</source>
        <translation>Es wäre um %1 Grad gegen die Neigung gekippt, die seine Kamera angibt.</translation>
    </message>
    <message>
        <source>It would lean by %1 deg from upright, though it states no tilt.</source>
        <translation>Es wäre um %1 Grad gekippt, obwohl es keine Neigung angibt.</translation>
    </message>
    <message>
        <source>Its rotation is therefore not known: check its position, and retake it if that is right.</source>
        <translation>Wie es gedreht ist, ist darum nicht bekannt: Prüfen Sie seine Position, und nehmen Sie es neu auf, wenn sie stimmt.</translation>
    </message>
    <message>
        <source>Its rotation is therefore not known: take another photo beside it.</source>
        <translation>Wie es gedreht ist, ist darum nicht bekannt: Nehmen Sie daneben ein weiteres Foto auf.</translation>
    </message>
    <message>
        <source>All photos of %1 lie on one line.</source>
        <translation>Alle Fotos von %1 liegen auf einer Linie.</translation>
    </message>
    <message>
        <source>Nothing but the tilts that they state holds the turn about that line, which is known to %1 deg (one standard deviation).</source>
        <translation>Die Drehung um diese Linie halten nur die Neigungen, die sie angeben; sie ist auf %1 Grad bekannt (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>Add a second rail, or one photo, beside the line.</source>
        <translation>Fügen Sie neben der Linie eine zweite Schiene oder ein Foto hinzu.</translation>
    </message>
    <message>
        <source>%1 of %2 photos lean by more than 3 degrees from what they state, or from upright if they state nothing.</source>
        <translation>%1 von %2 Fotos sind um mehr als 3 Grad gegen das gekippt, was sie angeben, oder gegen die Senkrechte, wenn sie nichts angeben.</translation>
    </message>
    <message>
        <source>Most leans %1: by %2 deg.</source>
        <translation>Am meisten gekippt ist %1: um %2 Grad.</translation>
    </message>
    <message>
        <source>If the camera stood level, look at these photos, and at their positions.</source>
        <translation>Wenn die Kamera gerade stand, sehen Sie sich diese Fotos und ihre Positionen an.</translation>
    </message>
    <message>
        <source>Half a turn about the line to its neighbours explains what it shows about as well.</source>
        <translation>Eine halbe Drehung um die Linie zu den Nachbarn erklärt etwa ebenso gut, was es zeigt.</translation>
    </message>
    <message>
        <source>Which way it looks is not known: too little of what it shares with its neighbours lies clearly in front of them, so half a turn explains it as well.</source>
        <translation>Wohin es blickt, ist nicht bekannt: Zu wenig von dem, was es mit den Nachbarn gemeinsam hat, liegt klar vor ihnen, sodass eine halbe Drehung es ebenso gut erklärt.</translation>
    </message>
    <message>
        <source>Take a photo between them, or nearer to things.</source>
        <translation>Nehmen Sie ein Foto dazwischen oder näher an den Dingen auf.</translation>
    </message>
    <message>
        <source>How it is turned against the others is not known: its position asks for another turn than what it shows in common with its neighbours.</source>
        <translation>Wie es gegen die anderen gedreht ist, ist nicht bekannt: Seine Position verlangt eine andere Drehung als das, was es mit den Nachbarn gemeinsam zeigt.</translation>
    </message>
    <message>
        <source>Check the positions.</source>
        <translation>Prüfen Sie die Positionen.</translation>
    </message>
    <message>
        <source>Its matches contradict where the other photos are.</source>
        <translation>Was es mit anderen gemeinsam zeigt, widerspricht deren Positionen.</translation>
    </message>
    <message>
        <source>Check its position tag.</source>
        <translation>Prüfen Sie seine Ortsangabe.</translation>
    </message>
    <message>
        <source>There is no other photo to compare it with.</source>
        <translation>Es gibt kein anderes Foto, mit dem es verglichen werden könnte.</translation>
    </message>
    <message>
        <source>It was compared with no other photo.</source>
        <translation>Es wurde mit keinem anderen Foto verglichen.</translation>
    </message>
    <message>
        <source>No neighbour shares enough with it.</source>
        <translation>Kein Nachbar hat genug mit ihm gemeinsam.</translation>
    </message>
    <message>
        <source>Compared with %1 photos, it shares enough with %2, and nothing confirms that.</source>
        <translation>Verglichen mit %1 Fotos hat es mit %2 genug gemeinsam, und nichts bestätigt das.</translation>
    </message>
    <message>
        <source>What its neighbours say of it contradicts what they say of each other.</source>
        <translation>Was die Nachbarn von ihm sagen, widerspricht dem, was sie voneinander sagen.</translation>
    </message>
    <message>
        <source>The survey falls into %1 parts that share no photo pair; part %2 is %3.</source>
        <translation>Das Projekt zerfällt in %1 Teile, die kein Fotopaar verbindet; Teil %2 ist %3.</translation>
    </message>
    <message>
        <source>Each part is aligned for itself, by its positions: take photos between them.</source>
        <translation>Jeder Teil wird für sich nach seinen Positionen ausgerichtet: Nehmen Sie Fotos dazwischen auf.</translation>
    </message>
    <message>
        <source>Nothing fixes the common heading of %1: they stand at one place.</source>
        <translation>Nichts legt die gemeinsame Richtung von %1 fest: Sie stehen an einer Stelle.</translation>
    </message>
    <message>
        <source>Only how they are turned to each other is known.</source>
        <translation>Bekannt ist nur, wie sie gegeneinander gedreht sind.</translation>
    </message>
    <message>
        <source>The positions of %1 contradict what the photos show of them (%2 % of the directions agree).</source>
        <translation>Die Positionen von %1 widersprechen dem, was die Fotos davon zeigen (%2 % der Richtungen stimmen überein).</translation>
    </message>
    <message>
        <source>They seem to be off by about %1 m.</source>
        <translation>Sie sind anscheinend um etwa %1 m falsch.</translation>
    </message>
    <message>
        <source>Check the position tags, or state how rough they are.</source>
        <translation>Prüfen Sie die Ortsangaben, oder geben Sie an, wie ungenau sie sind.</translation>
    </message>
    <message>
        <source>The alignment of %1 is doubtful: only %2 % of the matches that pairs agreed on fit it.</source>
        <translation>Die Ausrichtung von %1 ist zweifelhaft: Nur %2 % der Übereinstimmungen der Paare passen dazu.</translation>
    </message>
    <message>
        <source>The photos fall into %1 parts that share nothing certain; part %2 is %3.</source>
        <translation>Die Fotos zerfallen in %1 Teile, die nichts sicher gemeinsam haben; Teil %2 ist %3.</translation>
    </message>
    <message>
        <source>Only the largest part is placed: take photos between the parts.</source>
        <translation>Nur der größte Teil erhält Positionen: Nehmen Sie Fotos zwischen den Teilen auf.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the given distance is %1 % too long.</source>
        <translation>Nach der Druckgröße der Marken ist der angegebene Abstand um %1 % zu lang.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the given distance is %1 % too short.</source>
        <translation>Nach der Druckgröße der Marken ist der angegebene Abstand um %1 % zu kurz.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the height of the lens is %1 % too long.</source>
        <translation>Nach der Druckgröße der Marken ist die Höhe des Objektivs um %1 % zu lang.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the height of the lens is %1 % too short.</source>
        <translation>Nach der Druckgröße der Marken ist die Höhe des Objektivs um %1 % zu kurz.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, lengths in the other survey&apos;s frame are %1 % too long.</source>
        <translation>Nach der Druckgröße der Marken sind Längen im anderen Projekt um %1 % zu lang.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, lengths in the other survey&apos;s frame are %1 % too short.</source>
        <translation>Nach der Druckgröße der Marken sind Längen im anderen Projekt um %1 % zu kurz.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, all tapes are %1 % too long (known to %2 %).</source>
        <translation>Nach der Druckgröße der Marken sind alle Maße um %1 % zu lang (auf %2 % bekannt).</translation>
    </message>
    <message>
        <source>By the printed size of the tags, all tapes are %1 % too short (known to %2 %).</source>
        <translation>Nach der Druckgröße der Marken sind alle Maße um %1 % zu kurz (auf %2 % bekannt).</translation>
    </message>
    <message>
        <source>Measure the printed tags and the distance again.</source>
        <translation>Messen Sie die gedruckten Marken und den Abstand noch einmal.</translation>
    </message>
    <message>
        <source>Measure the printed tags, and the height of the lens.</source>
        <translation>Messen Sie die gedruckten Marken und die Höhe des Objektivs.</translation>
    </message>
    <message>
        <source>Measure a printed tag with a ruler, then the tapes.</source>
        <translation>Messen Sie eine gedruckte Marke mit einem Lineal, dann die Maßbänder.</translation>
    </message>
    <message>
        <source>Perhaps a tag was moved between the surveys, or the size of their tags was given differently.</source>
        <translation>Vielleicht wurde zwischen den Projekten eine Marke umgehängt, oder ihre Größe ist verschieden angegeben.</translation>
    </message>
    <message>
        <source>AprilTag %1 hangs elsewhere than in the other survey, and was not used to join them.</source>
        <translation>AprilTag %1 hängt anderswo als im anderen Projekt und wurde nicht benutzt, um beide zu verbinden.</translation>
    </message>
    <message>
        <source>Hang tags where nobody moves them.</source>
        <translation>Hängen Sie Marken dort auf, wo niemand sie umhängt.</translation>
    </message>
    <message>
        <source>The scale is not known: the photos show too little of the floor below them, and no distance was given.</source>
        <translation>Der Maßstab ist nicht bekannt: Die Fotos zeigen zu wenig vom Boden unter ihnen, und es wurde kein Abstand angegeben.</translation>
    </message>
    <message>
        <source>Give the distance between two photos.</source>
        <translation>Geben Sie den Abstand zweier Fotos an.</translation>
    </message>
    <message>
        <source>Nobody said how high the lens stands over the floor: %1 m is a guess, and all lengths may be wrong by a quarter and more.</source>
        <translation>Niemand hat gesagt, wie hoch das Objektiv über dem Boden steht: %1 m sind geraten, und alle Längen können um ein Viertel und mehr falsch sein.</translation>
    </message>
    <message>
        <source>Give the height of the lens, or the distance between two photos.</source>
        <translation>Geben Sie die Höhe des Objektivs an, oder den Abstand zweier Fotos.</translation>
    </message>
    <message>
        <source>All lengths are known to %1 % alone (one standard deviation): align the survey with a known height of the lens, or a known distance, and export again.</source>
        <translation>Alle Längen sind nur auf %1 % bekannt (eine Standardabweichung): Richten Sie die Vermessung mit einer bekannten Höhe des Objektivs oder einer bekannten Entfernung aus, und exportieren Sie neu.</translation>
    </message>
    <message>
        <source>Nobody has drawn the room: its walls are a rectangle around what the photos show.</source>
        <translation>Niemand hat den Raum gezeichnet: Seine Wände sind ein Rechteck um das, was die Fotos zeigen.</translation>
    </message>
    <message>
        <source>The world of a dataset with depth has walls as they stand.</source>
        <translation>Die Welt eines Datensatzes mit Tiefe hat die Wände, wie sie stehen.</translation>
    </message>
    <message>
        <source>Where AprilTag %1 hangs is not known: 1 photo sees it (%2), but not from places far enough apart.</source>
        <translation>Wo AprilTag %1 hängt, ist nicht bekannt: 1 Foto sieht ihn (%2), aber nicht von weit genug auseinander liegenden Stellen.</translation>
    </message>
    <message>
        <source>Where AprilTag %1 hangs is not known: %2 photos see it (%3), but not from places far enough apart.</source>
        <translation>Wo AprilTag %1 hängt, ist nicht bekannt: %2 Fotos sehen ihn (%3), aber nicht von weit genug auseinander liegenden Stellen.</translation>
    </message>
    <message>
        <source>Take a photo near it.</source>
        <translation>Nehmen Sie in seiner Nähe ein Foto auf.</translation>
    </message>
    <message>
        <source>AprilTag %1 hangs in more than one place, or was moved: %2 photos see it at (%3, %4, %5), but %6 elsewhere.</source>
        <translation>AprilTag %1 hängt an mehreren Stellen oder wurde umgehängt: %2 Fotos sehen ihn bei (%3; %4; %5), aber %6 anderswo.</translation>
    </message>
    <message>
        <source>Hang each number once.</source>
        <translation>Hängen Sie jede Nummer nur einmal auf.</translation>
    </message>
    <message>
        <source>No AprilTag was found that two photos see: hang tags where photos see them from up to 4 m away, or leave out --tag-size.</source>
        <translation>Es wurde kein AprilTag gefunden, den zwei Fotos sehen: Hängen Sie Marken dort auf, wo Fotos sie aus höchstens 4 m sehen, oder geben Sie keine Größe an.</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the left of the picture&apos;s middle, %2 degrees above the horizon (%3 % of the sphere).</source>
        <translation>Wo andere Fotos hindurchsehen, steht etwas: %1 Grad links der Bildmitte, %2 Grad über dem Horizont (%3 % der Kugel).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the left of the picture&apos;s middle, %2 degrees below the horizon (%3 % of the sphere).</source>
        <translation>Wo andere Fotos hindurchsehen, steht etwas: %1 Grad links der Bildmitte, %2 Grad unter dem Horizont (%3 % der Kugel).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the right of the picture&apos;s middle, %2 degrees above the horizon (%3 % of the sphere).</source>
        <translation>Wo andere Fotos hindurchsehen, steht etwas: %1 Grad rechts der Bildmitte, %2 Grad über dem Horizont (%3 % der Kugel).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the right of the picture&apos;s middle, %2 degrees below the horizon (%3 % of the sphere).</source>
        <translation>Wo andere Fotos hindurchsehen, steht etwas: %1 Grad rechts der Bildmitte, %2 Grad unter dem Horizont (%3 % der Kugel).</translation>
    </message>
    <message>
        <source>If it is a person, step aside and take it again.</source>
        <translation>Wenn es eine Person ist, treten Sie zur Seite, und nehmen Sie es neu auf.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read; retake the photo.</source>
        <translation>Die Datei %1 kann nicht gelesen werden; nehmen Sie das Foto neu auf.</translation>
    </message>
    <message>
        <source>The position tags are mirrored: one axis points the wrong way, or x and y are exchanged.</source>
        <translation>Die Ortsangaben sind gespiegelt: Eine Achse zeigt verkehrt herum, oder x und y sind vertauscht.</translation>
    </message>
    <message>
        <source>No photo is aligned; correct the axis in all positions, and align again.</source>
        <translation>Kein Foto ist ausgerichtet; berichtigen Sie die Achse in allen Positionen, und richten Sie noch einmal aus.</translation>
    </message>
    <message>
        <source>The scale of the tags differs along the axes: against x, the tags are %1 times as long along y as the photos show.</source>
        <translation>Der Maßstab der Angaben ist je Achse verschieden: Gegenüber x sind sie entlang y %1-mal so lang, wie die Fotos zeigen.</translation>
    </message>
    <message>
        <source>Measure the steps along the rails and between them, correct the positions, and align again.</source>
        <translation>Messen Sie die Schritte entlang der Schienen und dazwischen, berichtigen Sie die Positionen, und richten Sie noch einmal aus.</translation>
    </message>
    <message>
        <source>The scale of the tags is wrong, or the height of the lens: by the floor that the photos show, the tags lie %1 times as far apart as the photos.</source>
        <translation>Der Maßstab der Angaben oder die Höhe des Objektivs ist falsch: Nach dem Boden, den die Fotos zeigen, liegen die Angaben %1-mal so weit auseinander wie die Fotos.</translation>
    </message>
    <message>
        <source>Measure the rail&apos;s steps and the lens&apos;s height, correct what is wrong, and align again.</source>
        <translation>Messen Sie die Schritte der Schiene und die Höhe des Objektivs, berichtigen Sie, was falsch ist, und richten Sie noch einmal aus.</translation>
    </message>
    <message>
        <source>How 1 photo is turned is not known: %1.</source>
        <translation>Wie 1 Foto gedreht ist, ist nicht bekannt: %1.</translation>
    </message>
    <message>
        <source>How %1 photos are turned is not known: %2.</source>
        <translation>Wie %1 Fotos gedreht sind, ist nicht bekannt: %2.</translation>
    </message>
    <message>
        <source>1 photo is left out, since the alignment found no pose that holds: %1.</source>
        <translation>1 Foto wird ausgelassen, weil die Ausrichtung keine sichere Lage fand: %1.</translation>
    </message>
    <message>
        <source>%1 photos are left out, since the alignment found no pose that holds: %2.</source>
        <translation>%1 Fotos werden ausgelassen, weil die Ausrichtung keine sichere Lage fand: %2.</translation>
    </message>
    <message>
        <source>1 photo is left out, since nobody knows where it was taken: %1.</source>
        <translation>1 Foto wird ausgelassen, weil niemand weiß, wo es aufgenommen wurde: %1.</translation>
    </message>
    <message>
        <source>%1 photos are left out, since nobody knows where they were taken: %2.</source>
        <translation>%1 Fotos werden ausgelassen, weil niemand weiß, wo sie aufgenommen wurden: %2.</translation>
    </message>
    <message>
        <source>Aligning from the pictures alone finds that out.</source>
        <translation>Das Ausrichten allein nach den Bildern findet es heraus.</translation>
    </message>
    <message>
        <source>Look at what the alignment says of each, mend it, and align again.</source>
        <translation>Sehen Sie sich an, was die Ausrichtung von jedem sagt, beheben Sie es, und richten Sie noch einmal aus.</translation>
    </message>
    <message>
        <source>The alignment puts 1 photo nearer to another station than to the photo&apos;s own: %1.</source>
        <translation>Die Ausrichtung setzt 1 Foto näher an eine andere Station als an die eigene: %1.</translation>
    </message>
    <message>
        <source>The alignment puts %1 photos nearer to another station than to the photo&apos;s own: %2.</source>
        <translation>Die Ausrichtung setzt %1 Fotos näher an eine andere Station als an die eigene: %2.</translation>
    </message>
    <message>
        <source>The dataset has the solved places; retag the photos, and align again.</source>
        <translation>Der Datensatz hat die gelösten Orte; ordnen Sie die Fotos neu zu, und richten Sie noch einmal aus.</translation>
    </message>
    <message>
        <source>1 photo has left the alignment, which was made with the earlier places; align again before you export.</source>
        <translation>1 Foto hat die Ausrichtung verlassen, die mit den früheren Orten gemacht wurde; richten Sie vor dem Export noch einmal aus.</translation>
    </message>
    <message>
        <source>%1 photos have left the alignment, which was made with the earlier places; align again before you export.</source>
        <translation>%1 Fotos haben die Ausrichtung verlassen, die mit den früheren Orten gemacht wurde; richten Sie vor dem Export noch einmal aus.</translation>
    </message>
    <message>
        <source>Its place contradicts how far the position tags put it from a neighbour: what both show alike may be of two places.</source>
        <translation>Sein Ort widerspricht dem Abstand, den die Ortsangaben zu einem Nachbarn nennen: Was beide gleich zeigen, kann von zwei Orten sein.</translation>
    </message>
    <message>
        <source>The position tags are rough, so the places were solved from the pictures.</source>
        <translation>Die Positionsangaben sind ungenau, also wurden die Orte aus den Bildern berechnet.</translation>
    </message>
    <message>
        <source>Only %1 of %2 photos hang together, too few to tell their place from another that looks like it.</source>
        <translation>Nur %1 von %2 Fotos hängen zusammen, zu wenige, um ihren Ort von einem anderen zu unterscheiden, der ebenso aussieht.</translation>
    </message>
    <message>
        <source>Take photos between them and the others.</source>
        <translation>Machen Sie Fotos zwischen ihnen und den anderen.</translation>
    </message>
    <message>
        <source>Comparing what photos show</source>
        <translation>Vergleichen, was die Fotos zeigen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CornerModel</name>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CoverageLegend</name>
    <message>
        <source>Legend of the plan</source>
        <translation>Legende des Plans</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CoverageView</name>
    <message>
        <source>Coverage of the room</source>
        <translation>Abdeckung des Raums</translation>
    </message>
    <message>
        <source>%L1 px</source>
        <translation>%L1 px</translation>
    </message>
    <message>
        <source>%L1°</source>
        <translation>%L1°</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 und mehr</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::DeskRemote</name>
    <message>
        <source>%1: the photo is being downloaded and checked.</source>
        <translation>%1: Das Foto wird heruntergeladen und geprüft.</translation>
    </message>
    <message>
        <source>Open a survey in the window.</source>
        <translation>Öffnen Sie am Computer ein Projekt.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) left</source>
        <translation>
            <numerusform>Noch %n Foto</numerusform>
            <numerusform>Noch %n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was done: the press came too late, or was for another station. Look at what is next, and press again.</source>
        <translation>Nichts geschah: Der Tastendruck kam zu spät oder galt einem anderen Standort. Sehen Sie nach, was als Nächstes kommt, und drücken Sie noch einmal.</translation>
    </message>
    <message>
        <source>Nothing was done: the camera is not ready for that.</source>
        <translation>Nichts geschah: Die Kamera ist dafür nicht bereit.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::DriveView</name>
    <message>
        <source>What the robot&apos;s camera sees</source>
        <translation>Was die Kamera des Roboters sieht</translation>
    </message>
    <message>
        <source>outside of what was scanned</source>
        <translation>außerhalb des Aufgenommenen</translation>
    </message>
    <message>
        <source>no photo sees this place</source>
        <translation>kein Foto sieht diesen Ort</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>Fehler nicht bekannt</translation>
    </message>
    <message>
        <source>expected error %L1 px</source>
        <translation>erwarteter Fehler %L1 px</translation>
    </message>
    <message>
        <source>%1, %L2 cm away, %3, %L4 ms</source>
        <translation>%1, %L2 cm entfernt, %3, %L4 ms</translation>
    </message>
    <message>
        <source>scene model %1, sampling %2</source>
        <translation>Szenenmodell %1, Abtastung %2</translation>
    </message>
    <message>
        <source>, coarse until it is decoded</source>
        <translation>, grob, bis das Foto gelesen ist</translation>
    </message>
    <message>
        <source>, from the photo before until it is decoded</source>
        <translation>, aus dem Foto davor, bis es gelesen ist</translation>
    </message>
    <message>
        <source>Rendering...</source>
        <translation>Wird berechnet...</translation>
    </message>
    <message>
        <source>Make a preview of the open survey, or open a dataset.</source>
        <translation>Machen Sie eine Vorschau des offenen Projekts, oder öffnen Sie einen Datensatz.</translation>
    </message>
    <message>
        <source>The robot&apos;s own picture: %1</source>
        <translation>Eigenes Bild des Roboters: %1</translation>
    </message>
    <message>
        <source>expected error: 0 to %1 px and more</source>
        <translation>erwarteter Fehler: 0 bis %1 px und mehr</translation>
    </message>
    <message>
        <source>W A S D or the arrow keys drive, Q and E go sideways; drag to turn. Shift and a click put the object there.</source>
        <translation>W A S D oder die Pfeiltasten fahren, Q und E gehen seitwärts; Ziehen dreht. Umschalt und ein Klick stellen das Objekt dorthin.</translation>
    </message>
    <message>
        <source>, %1 % of the size while it drives</source>
        <translation>, %1 % der Größe während der Fahrt</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Lay the object, or take it away</source>
        <translation>Das Objekt hinlegen oder wegnehmen</translation>
    </message>
    <message>
        <source>Make the object larger or smaller</source>
        <translation>Das Objekt größer oder kleiner machen</translation>
    </message>
    <message>
        <source>Turn the object</source>
        <translation>Das Objekt drehen</translation>
    </message>
    <message>
        <source>Shift and the arrow keys</source>
        <translation>Umschalt und die Pfeiltasten</translation>
    </message>
    <message>
        <source>Move the object</source>
        <translation>Das Objekt verschieben</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Umschalt und ein Klick</translation>
    </message>
    <message>
        <source>Stand the object on the surface there</source>
        <translation>Das Objekt dort auf die Fläche stellen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportMode</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Make a dataset for simulators</source>
        <translation>Einen Datensatz für Simulatoren machen</translation>
    </message>
    <message>
        <source>What and where</source>
        <translation>Was und wohin</translation>
    </message>
    <message>
        <source>A folder that does not exist yet</source>
        <translation>Ein Ordner, den es noch nicht gibt</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Fo&amp;lder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>Sphere (nothing more is computed)</source>
        <translation>Kugel (nichts weiter wird berechnet)</translation>
    </message>
    <message>
        <source>Room: walls, floor, ceiling (a minute or two)</source>
        <translation>Raum: Wände, Boden, Decke (ein, zwei Minuten)</translation>
    </message>
    <message>
        <source>Depth of each pixel (some seconds a photo)</source>
        <translation>Tiefe jedes Pixels (einige Sekunden je Foto)</translation>
    </message>
    <message>
        <source>The cheapest that holds a tolerance (all are tried and measured)</source>
        <translation>Das billigste, das eine Toleranz hält (alle werden gemessen)</translation>
    </message>
    <message>
        <source>What views of places between photos can be computed with; cheaper ones come with it</source>
        <translation>Womit Ansichten zwischen Fotos berechnet werden; billigere Modelle kommen mit</translation>
    </message>
    <message>
        <source>S&amp;cene model</source>
        <translation>S&amp;zenenmodell</translation>
    </message>
    <message>
        <source>Eno&amp;ugh for</source>
        <translation>&amp;Genügt für</translation>
    </message>
    <message>
        <source>Fastest views (photos grow by about 2 %)</source>
        <translation>Schnellste Ansichten (Fotos wachsen um etwa 2 %)</translation>
    </message>
    <message>
        <source>Smaller (0.6 %), views of new places take longer</source>
        <translation>Kleiner (0,6 %), Ansichten neuer Orte dauern länger</translation>
    </message>
    <message>
        <source>How far apart the marks are that let a part of a photo be decoded by itself</source>
        <translation>Wie weit die Marken auseinanderliegen, mit denen ein Teil eines Fotos für sich gelesen wird</translation>
    </message>
    <message>
        <source>&amp;Optimised for</source>
        <translation>O&amp;ptimiert für</translation>
    </message>
    <message>
        <source>Open the folder &amp;when it is done</source>
        <translation>Danach den Ordner ö&amp;ffnen</translation>
    </message>
    <message>
        <source>within</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>E&amp;rneut prüfen</translation>
    </message>
    <message>
        <source>Look again at what the dataset would have and lack</source>
        <translation>Erneut nachsehen, was der Datensatz enthielte und was fehlt</translation>
    </message>
    <message>
        <source>Look at them in &amp;Review</source>
        <translation>In &amp;Sichten ansehen</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>Stop; nothing of the dataset is left then</source>
        <translation>Anhalten; vom Datensatz bleibt dann nichts</translation>
    </message>
    <message>
        <source>Open the fol&amp;der</source>
        <translation>Ord&amp;ner öffnen</translation>
    </message>
    <message>
        <source>Folder of the dataset</source>
        <translation>Ordner des Datensatzes</translation>
    </message>
    <message>
        <source>No program could open %1.</source>
        <translation>Kein Programm konnte %1 öffnen.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2, in %3.</source>
        <translation>
            <numerusform>%1: %n Foto, %2, in %3.</numerusform>
            <numerusform>%1: %n Fotos, %2, in %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>What the camera carries along covers %1 % of each photo. The dataset shows floor and walls there, as other photos see them.</source>
        <translation>Was die Kamera mitführt, bedeckt %1 % jedes Fotos. Der Datensatz zeigt dort Boden und Wände, wie andere Fotos sie sehen.</translation>
    </message>
    <message>
        <source>No survey is open.</source>
        <translation>Kein Projekt ist offen.</translation>
    </message>
    <message>
        <source>Trying one photo...</source>
        <translation>Ein Foto wird probiert...</translation>
    </message>
    <message>
        <source>Not checked yet.</source>
        <translation>Noch nicht geprüft.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s), about %1 and %2; %3 are free.</source>
        <translation>
            <numerusform>%n Foto, etwa %1 und %2; %3 sind frei.</numerusform>
            <numerusform>%n Fotos, etwa %1 und %2; %3 sind frei.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) are doubtful or failed, and nobody has decided.</source>
        <translation>
            <numerusform>%n Foto ist zweifelhaft oder fehlgeschlagen, und niemand hat entschieden.</numerusform>
            <numerusform>%n Fotos sind zweifelhaft oder fehlgeschlagen, und niemand hat entschieden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is missing or doubtful.</source>
        <translation>Nichts fehlt oder ist zweifelhaft.</translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>in %n Foto</numerusform>
            <numerusform>in %n Fotos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n private region(s) %1 will be blurred.</source>
        <translation>
            <numerusform>%n privater Bereich %1 wird unkenntlich gemacht.</numerusform>
            <numerusform>%n private Bereiche %1 werden unkenntlich gemacht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Measuring all that is tried comes on top of that.</source>
        <translation>Das Messen aller Versuche kommt hinzu.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportPresenter</name>
    <message>
        <source>Looking before the export</source>
        <translation>Vor dem Export wird nachgesehen</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Stopped; nothing of the dataset is left.</source>
        <translation>Angehalten; vom Datensatz bleibt nichts.</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n photo(s) to %1: %2.</source>
        <translation>
            <numerusform>%n Foto nach %1 exportiert: %2.</numerusform>
            <numerusform>%n Fotos nach %1 exportiert: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FaceSearchBar</name>
    <message>
        <source>Stop; the photos before are done, and the next search goes on behind them</source>
        <translation>Anhalten; die Fotos davor sind fertig, und die nächste Suche macht danach weiter</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Search %n photo(s) for faces</source>
        <translation>
            <numerusform>Gesichter in %n Foto &amp;suchen</numerusform>
            <numerusform>Gesichter in %n Fotos &amp;suchen</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Search for faces again</source>
        <translation>Gesichter noch einmal &amp;suchen</translation>
    </message>
    <message>
        <source>Exports show faces blurred that the search finds. It misses small, covered and turned ones: look through the photos, too.</source>
        <translation>Was die Suche findet, zeigen Exporte unkenntlich. Kleine, verdeckte und abgewandte Gesichter übersieht sie: Sehen Sie die Fotos auch selbst durch.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FindingWords</name>
    <message>
        <source>foreign, %L1 %</source>
        <translation>fremd, %L1 %</translation>
    </message>
    <message>
        <source>foreign</source>
        <translation>fremd</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>other size</source>
        <translation>andere Größe</translation>
    </message>
    <message>
        <source>no sphere</source>
        <translation>keine Kugel</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>andere Einstellung</translation>
    </message>
    <message>
        <source>too dark or bright</source>
        <translation>zu dunkel oder hell</translation>
    </message>
    <message>
        <source>other colours</source>
        <translation>andere Farben</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>unscharf</translation>
    </message>
    <message>
        <source>black area</source>
        <translation>schwarze Fläche</translation>
    </message>
    <message>
        <source>burnt area</source>
        <translation>ausgebrannte Fläche</translation>
    </message>
    <message>
        <source>leaning</source>
        <translation>schief</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>gedreht</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>anderer Ort</translation>
    </message>
    <message>
        <source>not moved</source>
        <translation>nicht bewegt</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FloorPicture</name>
    <message>
        <source>A PDF needs the program pdftoppm (poppler-utils); install it, or export the page as PNG or SVG.</source>
        <translation>Ein PDF braucht das Programm pdftoppm (poppler-utils); installieren Sie es, oder exportieren Sie die Seite als PNG oder SVG.</translation>
    </message>
    <message>
        <source>%1 is no PDF that can be drawn.</source>
        <translation>%1 ist kein PDF, das gezeichnet werden kann.</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read.</source>
        <translation>%1 ist kein Bild, das gelesen werden kann.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyModel</name>
    <message>
        <source>%L1 cm</source>
        <translation>%L1 cm</translation>
    </message>
    <message>
        <source>%L1 px</source>
        <translation>%L1 px</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>95 of 100 places are displaced by no more: within the tolerance.</source>
        <translation>95 von 100 Stellen sind höchstens so weit verschoben: innerhalb der Toleranz.</translation>
    </message>
    <message>
        <source>95 of 100 places are displaced by no more: beyond the tolerance.</source>
        <translation>95 von 100 Stellen sind höchstens so weit verschoben: außerhalb der Toleranz.</translation>
    </message>
    <message>
        <source>The pictures had too little in common to say.</source>
        <translation>Die Bilder hatten zu wenig gemeinsam, um etwas zu sagen.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2</source>
        <translation>
            <numerusform>%1: %n Foto, %2</numerusform>
            <numerusform>%1: %n Fotos, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyPanel</name>
    <message>
        <source>How dense?</source>
        <translation>Wie dicht?</translation>
    </message>
    <message>
        <source>Robot&apos;s ca&amp;mera</source>
        <translation>Kamera des &amp;Roboters</translation>
    </message>
    <message>
        <source>T&amp;olerance</source>
        <translation>Toleran&amp;z</translation>
    </message>
    <message>
        <source>With &amp;depth (takes minutes)</source>
        <translation>&amp;Mit Tiefe (dauert Minuten)</translation>
    </message>
    <message>
        <source>Also estimate how far away every pixel is, which lets grids be much coarser</source>
        <translation>Auch schätzen, wie weit jeder Pixel entfernt ist; das Raster kann dann viel gröber sein</translation>
    </message>
    <message>
        <source>Stud&amp;y the grid</source>
        <translation>Raster &amp;untersuchen</translation>
    </message>
    <message>
        <source>Leave photos out, render what they would show from the rest, and compare</source>
        <translation>Fotos auslassen, aus dem Rest berechnen, was sie zeigen würden, und vergleichen</translation>
    </message>
    <message>
        <source>Stop; what was found is kept for the next run</source>
        <translation>Anhalten; was gefunden wurde, bleibt für das nächste Mal</translation>
    </message>
    <message>
        <source>Steps that were studied</source>
        <translation>Untersuchte Schrittweiten</translation>
    </message>
    <message>
        <source>Step to plan with</source>
        <translation>Schrittweite für den Plan</translation>
    </message>
    <message>
        <source>The coarsest step that holds the tolerance, for each scene model</source>
        <translation>Die gröbste Schrittweite, die die Toleranz hält, für jedes Szenenmodell</translation>
    </message>
    <message>
        <source>&amp;Use this step</source>
        <translation>Schritt &amp;verwenden</translation>
    </message>
    <message>
        <source>Plan with this step; where the plan is fixed, a new survey of the same room begins with it</source>
        <translation>Mit dieser Schrittweite planen; wo der Plan feststeht, beginnt ein neues Projekt desselben Raums damit</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyPresenter</name>
    <message>
        <source>Open a survey with a small block of photos, 5 x 5 at the finest step that you would use.</source>
        <translation>Öffnen Sie ein Projekt mit einem kleinen Block von Fotos, 5 x 5 mit der feinsten Schrittweite, die Sie nähmen.</translation>
    </message>
    <message numerus="yes">
        <source>This survey has %n photo(s). Take a block of 5 x 5 at the finest step that you would use (3 x 3 at least), and ask then.</source>
        <translation>
            <numerusform>Dieses Projekt hat %n Foto. Nehmen Sie einen Block von 5 x 5 mit der feinsten Schrittweite auf, die Sie nähmen (mindestens 3 x 3), und fragen Sie dann.</numerusform>
            <numerusform>Dieses Projekt hat %n Fotos. Nehmen Sie einen Block von 5 x 5 mit der feinsten Schrittweite auf, die Sie nähmen (mindestens 3 x 3), und fragen Sie dann.</numerusform>
        </translation>
    </message>
    <message>
        <source>Studying the grid of %1</source>
        <translation>Das Raster von %1 wird untersucht</translation>
    </message>
    <message>
        <source>Stopped. What was found is kept: the next study goes on from there.</source>
        <translation>Angehalten. Was gefunden wurde, bleibt: die nächste Untersuchung geht von dort weiter.</translation>
    </message>
    <message numerus="yes">
        <source>%1
Found in %2: %n photo(s), %L3 cm apart.</source>
        <translation>
            <numerusform>%1
Gefunden in %2: %n Foto, %L3 cm Abstand.</numerusform>
            <numerusform>%1
Gefunden in %2: %n Fotos, %L3 cm Abstand.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::HelpWindow</name>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::LoginForm</name>
    <message>
        <source>&amp;Keep them in the system&apos;s keychain</source>
        <translation>Im Schlüssel&amp;bund des Systems behalten</translation>
    </message>
    <message>
        <source>The camera asks who is there</source>
        <translation>Die Kamera fragt, wer da ist</translation>
    </message>
    <message>
        <source>The camera at %1 did not accept this user name and password.</source>
        <translation>Die Kamera an %1 hat Benutzername und Passwort nicht angenommen.</translation>
    </message>
    <message>
        <source>The camera at %1 is in client mode, and wants a user name and a password.</source>
        <translation>Die Kamera an %1 ist im Client-Modus und verlangt Benutzername und Passwort.</translation>
    </message>
    <message>
        <source>As set in the camera; at first THETA and its serial number.</source>
        <translation>Wie in der Kamera eingestellt; zuerst THETA und ihre Seriennummer.</translation>
    </message>
    <message>
        <source>As set in the camera; at first the digits of its serial number.</source>
        <translation>Wie in der Kamera eingestellt; zuerst die Ziffern ihrer Seriennummer.</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>&amp;User name:</source>
        <translation>Be&amp;nutzername:</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>&amp;Passwort:</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MainWindow</name>
    <message>
        <source>Modes</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Plan of the room</source>
        <translation>Plan des Raums</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Spherewalk</source>
        <translation>Spherewalk</translation>
    </message>
    <message>
        <source>Show what runs, and what has ended (Ctrl+T)</source>
        <translation>Zeigen, was läuft und was beendet ist (Strg+T)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>The start page (Ctrl+0)</source>
        <translation>Die Startseite (Strg+0)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 - Spherewalk</source>
        <translation>%1 - Spherewalk</translation>
    </message>
    <message>
        <source>%1 of %2 stations have a photo</source>
        <translation>%1 von %2 Standorten haben ein Foto</translation>
    </message>
    <message>
        <source>%1; another program writes</source>
        <translation>%1; ein anderes Programm schreibt</translation>
    </message>
    <message numerus="yes">
        <source>%n task(s)</source>
        <translation>
            <numerusform>%n Aufgabe</numerusform>
            <numerusform>%n Aufgaben</numerusform>
        </translation>
    </message>
    <message>
        <source>Open survey</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>practice room</source>
        <translation>Übungsraum</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New survey</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>&amp;Open survey...</source>
        <translation>Projekt ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>&amp;Practice room</source>
        <translation>Übungs&amp;raum</translation>
    </message>
    <message>
        <source>&amp;Close survey</source>
        <translation>Projekt s&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Import photos...</source>
        <translation>Fotos &amp;importieren...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Guide to this page</source>
        <translation>&amp;Anleitung zu dieser Seite</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About Spherewalk</source>
        <translation>&amp;Über Spherewalk</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>The language changes when the program is started the next time.</source>
        <translation>Die Sprache ändert sich beim nächsten Start des Programms.</translation>
    </message>
    <message>
        <source>Spherewalk %1, free software under the GNU General Public License, version 3 or later.</source>
        <translation>Spherewalk %1, freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
    <message>
        <source>Open a survey first; the photos become part of it.</source>
        <translation>Öffnen Sie zuerst ein Projekt; die Fotos werden Teil davon.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Positions of the photos</source>
        <translation>Positionen der Fotos</translation>
    </message>
    <message>
        <source>Positions (*.csv)</source>
        <translation>Positionen (*.csv)</translation>
    </message>
    <message>
        <source>Folder of the photos</source>
        <translation>Ordner der Fotos</translation>
    </message>
    <message>
        <source>Importing photos</source>
        <translation>Fotos werden importiert</translation>
    </message>
    <message>
        <source>&amp;Tour in five steps</source>
        <translation>&amp;Rundgang in fünf Schritten</translation>
    </message>
    <message>
        <source>&amp;Recent surveys</source>
        <translation>&amp;Letzte Projekte</translation>
    </message>
    <message>
        <source>Import photos &amp;without positions...</source>
        <translation>Fotos &amp;ohne Positionen importieren...</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) imported, %1 were there already.</source>
        <translation>
            <numerusform>%n Foto importiert, %1 waren schon da.</numerusform>
            <numerusform>%n Fotos importiert, %1 waren schon da.</numerusform>
        </translation>
    </message>
    <message>
        <source>Align solves where they were taken.</source>
        <translation>Ausrichten berechnet, wo sie aufgenommen wurden.</translation>
    </message>
    <message>
        <source>Check them in Review.</source>
        <translation>Prüfen Sie sie in Sichten.</translation>
    </message>
    <message>
        <source>New survey by &amp;hand</source>
        <translation>Neues Projekt von &amp;Hand</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>Rundgang</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MeasurePanel</name>
    <message>
        <source>How right its views are</source>
        <translation>Wie richtig seine Ansichten sind</translation>
    </message>
    <message>
        <source>Open &amp;report</source>
        <translation>Ber&amp;icht öffnen</translation>
    </message>
    <message>
        <source>The page with error maps and trade-offs; the same as PDF lies beside it</source>
        <translation>Die Seite mit Fehlerkarten und Abwägungen; dasselbe als PDF liegt daneben</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Leave photos out, render what they would show from the rest, and compare</source>
        <translation>Fotos auslassen, aus dem Rest berechnen, was sie zeigen würden, und vergleichen</translation>
    </message>
    <message>
        <source>Stop; what was found is kept for the next run</source>
        <translation>Anhalten; was gefunden wurde, bleibt für das nächste Mal</translation>
    </message>
    <message>
        <source>Robot&apos;s camera</source>
        <translation>Kamera des Roboters</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Export a dataset first, or name the folder of one that is there.</source>
        <translation>Exportieren Sie zuerst einen Datensatz, oder nennen Sie den Ordner eines vorhandenen.</translation>
    </message>
    <message>
        <source>Stored: views whose choice is left to the dataset are made so.</source>
        <translation>Gespeichert: Ansichten, deren Wahl dem Datensatz überlassen ist, entstehen so.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MeasurePresenter</name>
    <message>
        <source>Measuring %1</source>
        <translation>%1 wird gemessen</translation>
    </message>
    <message>
        <source>Stopped. What was found is kept: measuring again goes on from there.</source>
        <translation>Angehalten. Was gefunden wurde, bleibt: das nächste Messen geht von dort weiter.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::NewSurveyForm</name>
    <message>
        <source>New survey</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>&amp;Create survey</source>
        <translation>Projekt an&amp;legen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>What the room is called; the survey&apos;s folder gets this name.</source>
        <translation>Wie der Raum heißt; der Ordner des Projekts bekommt diesen Namen.</translation>
    </message>
    <message>
        <source>Kept &amp;in</source>
        <translation>Liegt &amp;in</translation>
    </message>
    <message>
        <source>The folder in which the survey&apos;s folder is made.</source>
        <translation>Der Ordner, in dem der Ordner des Projekts entsteht.</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>room %1</source>
        <translation>Raum %1</translation>
    </message>
    <message>
        <source>There is a survey of this name already.</source>
        <translation>Ein Projekt dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>Makes the survey on the disk.</source>
        <translation>Legt das Projekt auf der Platte an.</translation>
    </message>
    <message>
        <source>Where surveys are kept</source>
        <translation>Wo Projekte liegen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ObjectFields</name>
    <message>
        <source>Object in the view</source>
        <translation>Objekt in der Ansicht</translation>
    </message>
    <message>
        <source>An object as a simulator would render it. With Shift, click in the view to stand it on the surface there, or on the plan. O lays it or takes it away, + and - change its size, comma and period turn it, and the arrow keys with Shift move it.</source>
        <translation>Ein Objekt, wie es ein Simulator zeichnen würde. Mit Umschalt klicken Sie in die Ansicht, um es dort auf die Fläche zu stellen, oder in den Plan. O legt es hin oder nimmt es weg, + und - ändern seine Größe, Komma und Punkt drehen es, und die Pfeiltasten mit Umschalt verschieben es.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>Mesh (OBJ file)...</source>
        <translation>Netz (OBJ-Datei)...</translation>
    </message>
    <message>
        <source>Size of the object</source>
        <translation>Größe des Objekts</translation>
    </message>
    <message>
        <source>Its longest side</source>
        <translation>Seine längste Seite</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>O&amp;bject</source>
        <translation>Obj&amp;ekt</translation>
    </message>
    <message>
        <source>Mesh with z up, in metres</source>
        <translation>Netz mit z nach oben, in Metern</translation>
    </message>
    <message>
        <source>Meshes (*.obj)</source>
        <translation>Netze (*.obj)</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ObjectStage</name>
    <message>
        <source>Reading %1</source>
        <translation>Lese %1</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PagePanel</name>
    <message>
        <source>A page to share</source>
        <translation>Eine Seite zum Weitergeben</translation>
    </message>
    <message>
        <source>Plan, panoramas to walk through, distances, and the notes of the review, in a folder that any browser opens. Nothing needs to be installed.</source>
        <translation>Plan, begehbare Panoramen, Entfernungen und die Notizen der Durchsicht in einem Ordner, den jeder Browser öffnet. Nichts muss installiert werden.</translation>
    </message>
    <message>
        <source>Write the page</source>
        <translation>Seite schreiben</translation>
    </message>
    <message>
        <source>Stop; nothing is written then</source>
        <translation>Anhalten; dann wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Ansehen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PagePresenter</name>
    <message>
        <source>Writing the page of %1</source>
        <translation>Schreiben der Seite von %1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2. Distances can be measured in %3 of them. Share the whole folder.</source>
        <translation>
            <numerusform>%1: %n Foto, %2. Entfernungen können in %3 davon gemessen werden. Geben Sie den ganzen Ordner weiter.</numerusform>
            <numerusform>%1: %n Fotos, %2. Entfernungen können in %3 davon gemessen werden. Geben Sie den ganzen Ordner weiter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PageWords</name>
    <message>
        <source>Panorama</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>Panorama of %1. Drag, or use the arrow keys.</source>
        <translation>Panorama von %1. Ziehen Sie, oder nehmen Sie die Pfeiltasten.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Plan of the room with the photos</source>
        <translation>Plan des Raums mit den Fotos</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>Auf dem Boden</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Entfernungen</translation>
    </message>
    <message>
        <source>± is one standard deviation, of the depth, of the click, and of the scale of the whole room as far as it is known.</source>
        <translation>± ist eine Standardabweichung der Tiefe, des Klicks und des Maßstabs des ganzen Raums, soweit er bekannt ist.</translation>
    </message>
    <message>
        <source>Remove the last one</source>
        <translation>Die letzte entfernen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Walk ahead</source>
        <translation>Vorwärts gehen</translation>
    </message>
    <message>
        <source>Walk back</source>
        <translation>Rückwärts gehen</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>This page needs JavaScript, which is switched off in this browser.</source>
        <translation>Diese Seite braucht JavaScript, das in diesem Browser abgeschaltet ist.</translation>
    </message>
    <message>
        <source>This browser shows no 3D graphics (WebGL), so there are no panoramas. Plan and notes work.</source>
        <translation>Dieser Browser zeigt keine 3D-Grafik (WebGL), darum gibt es keine Panoramen. Plan und Notizen gehen.</translation>
    </message>
    <message>
        <source>The file %1 could not be read. The folder must be copied whole.</source>
        <translation>Die Datei %1 konnte nicht gelesen werden. Der Ordner muss ganz kopiert werden.</translation>
    </message>
    <message>
        <source>1 photo</source>
        <translation>1 Foto</translation>
    </message>
    <message>
        <source>%1 photos</source>
        <translation>%1 Fotos</translation>
    </message>
    <message>
        <source>made by %1 on %2</source>
        <translation>gemacht von %1 am %2</translation>
    </message>
    <message>
        <source>All lengths are known to %1 %.</source>
        <translation>Alle Längen sind auf %1 % bekannt.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>failed the checks</source>
        <translation>bei der Prüfung durchgefallen</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>accepted by a person</source>
        <translation>von einem Menschen angenommen</translation>
    </message>
    <message>
        <source>no photo</source>
        <translation>kein Foto</translation>
    </message>
    <message>
        <source>photo rejected</source>
        <translation>Foto verworfen</translation>
    </message>
    <message>
        <source>photo not placed: its alignment failed</source>
        <translation>Foto ohne Ort: seine Ausrichtung misslang</translation>
    </message>
    <message>
        <source>This page was made of a dataset, which has no verdicts and no notes.</source>
        <translation>Diese Seite wurde aus einem Datensatz gemacht, der keine Urteile und keine Notizen hat.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, %3 m hoch</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high, ± %4 m</source>
        <translation>x %1 m, y %2 m, %3 m hoch, ± %4 m</translation>
    </message>
    <message>
        <source>Views that replace this photo are off by %1 pixels.</source>
        <translation>Ansichten, die dieses Foto ersetzen, weichen um %1 Pixel ab.</translation>
    </message>
    <message>
        <source>The heading of this photo is not known.</source>
        <translation>Die Richtung dieses Fotos ist nicht bekannt.</translation>
    </message>
    <message>
        <source>This photo has no depth: nothing can be measured in it.</source>
        <translation>Dieses Foto hat keine Tiefe: Nichts kann darin gemessen werden.</translation>
    </message>
    <message>
        <source>The depth there was not measured.</source>
        <translation>Die Tiefe wurde dort nicht gemessen.</translation>
    </message>
    <message>
        <source>Choose a point, with a click or with Enter for the middle.</source>
        <translation>Wählen Sie einen Punkt, mit einem Klick oder mit Enter für die Mitte.</translation>
    </message>
    <message>
        <source>Choose the other end.</source>
        <translation>Wählen Sie das andere Ende.</translation>
    </message>
    <message>
        <source>There is no photo to walk to in this direction.</source>
        <translation>In dieser Richtung ist kein Foto, zu dem man gehen kann.</translation>
    </message>
    <message>
        <source>%1 m ± %2 m</source>
        <translation>%1 m ± %2 m</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>walk ahead and back</source>
        <translation>vorwärts und rückwärts gehen</translation>
    </message>
    <message>
        <source>look up and down</source>
        <translation>nach oben und unten sehen</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>look level</source>
        <translation>waagerecht sehen</translation>
    </message>
    <message>
        <source>measure a distance</source>
        <translation>eine Entfernung messen</translation>
    </message>
    <message>
        <source>while measuring: take the middle of the picture</source>
        <translation>beim Messen: die Mitte des Bildes nehmen</translation>
    </message>
    <message>
        <source>while measuring: take back the last point</source>
        <translation>beim Messen: den letzten Punkt zurücknehmen</translation>
    </message>
    <message>
        <source>end measuring</source>
        <translation>das Messen beenden</translation>
    </message>
    <message>
        <source>this list</source>
        <translation>diese Liste</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Floor within reach of a photo: half the diagonal of the grid&apos;s cell</source>
        <translation>Boden in Reichweite eines Fotos: die halbe Diagonale der Rasterzelle</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>abgedeckt</translation>
    </message>
    <message>
        <source>Error of views</source>
        <translation>Fehler der Ansichten</translation>
    </message>
    <message>
        <source>95th percentile of displacement where the photo was left out</source>
        <translation>95. Perzentil der Verschiebung, wo das Foto weggelassen wurde</translation>
    </message>
    <message>
        <source>Uncertainty of the heading</source>
        <translation>Unsicherheit der Richtung</translation>
    </message>
    <message>
        <source>Standard deviation of each photo&apos;s heading, in pixels of a camera of 640 pixels and 57 degrees</source>
        <translation>Standardabweichung der Richtung jedes Fotos, in Pixeln einer Kamera mit 640 Pixeln und 57 Grad</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 px, the tolerance</source>
        <translation>%1 px, die Toleranz</translation>
    </message>
    <message>
        <source>%1 px and less</source>
        <translation>%1 px und weniger</translation>
    </message>
    <message>
        <source>%1 px and more</source>
        <translation>%1 px und mehr</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Foretold error of views</source>
        <translation>Vorhergesagter Fehler der Ansichten</translation>
    </message>
    <message>
        <source>Median displacement that the photos foretell for views from there, at their own height, in pixels of a camera of 640 pixels and 57 degrees</source>
        <translation>Median der Verschiebung, die die Fotos für Ansichten von dort in ihrer eigenen Höhe vorhersagen, in Pixeln einer Kamera mit 640 Pixeln und 57 Grad</translation>
    </message>
    <message>
        <source>nothing is known</source>
        <translation>nichts ist bekannt</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PanoramaPresenter</name>
    <message>
        <source>No photo is chosen.</source>
        <translation>Kein Foto ist gewählt.</translation>
    </message>
    <message>
        <source>Decoding %1...</source>
        <translation>%1 wird gelesen...</translation>
    </message>
    <message>
        <source>as seen from here, by measured depth</source>
        <translation>von hier gesehen, nach gemessener Tiefe</translation>
    </message>
    <message>
        <source>as seen from here, by the drawn walls</source>
        <translation>von hier gesehen, nach den gezeichneten Wänden</translation>
    </message>
    <message>
        <source>as seen from here, roughly</source>
        <translation>von hier gesehen, ungefähr</translation>
    </message>
    <message>
        <source>turned as the first</source>
        <translation>gedreht wie das erste</translation>
    </message>
    <message>
        <source>Moving %1 to here...</source>
        <translation>%1 wird hierher versetzt...</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PanoramaView</name>
    <message>
        <source>Photo to look around in</source>
        <translation>Foto zum Umsehen</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to look around; wheel, + and - change the field of view; 0 looks level</source>
        <translation>Ziehen oder Pfeiltasten sehen sich um; Rad, + und - ändern das Sichtfeld; 0 sieht waagerecht</translation>
    </message>
    <message>
        <source>A: %1</source>
        <translation>A: %1</translation>
    </message>
    <message>
        <source>heading %1°, %2° up, %3° wide</source>
        <translation>Richtung %1°, %2° hoch, %3° breit</translation>
    </message>
    <message>
        <source>B: %1
%2</source>
        <translation>B: %1
%2</translation>
    </message>
    <message>
        <source>Not aligned yet: the second photo is turned by what both show, roughly.</source>
        <translation>Noch nicht ausgerichtet: das zweite Foto ist ungefähr nach dem gedreht, was beide zeigen.</translation>
    </message>
    <message>
        <source>A box is being put around what exports shall show blurred.</source>
        <translation>Um das, was Exporte unkenntlich zeigen sollen, wird ein Rahmen gelegt.</translation>
    </message>
    <message>
        <source>Private region %1 of %2, found by the search</source>
        <translation>Privater Bereich %1 von %2, von der Suche gefunden</translation>
    </message>
    <message>
        <source>Private region %1 of %2, marked by hand</source>
        <translation>Privater Bereich %1 von %2, von Hand markiert</translation>
    </message>
    <message>
        <source>Drag a box. Or move this one: arrow keys move it, and with Shift they size it. Return hides what is in it, Escape leaves.</source>
        <translation>Ziehen Sie einen Rahmen auf. Oder verwenden Sie diesen: Pfeiltasten verschieben ihn, mit Umschalt ändern sie seine Größe. Eingabe verbirgt, was darin ist, Esc bricht ab.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PathPlayer</name>
    <message>
        <source>Pla&amp;y</source>
        <translation>Abs&amp;pielen</translation>
    </message>
    <message>
        <source>Drive the recorded path again, as fast as it was driven</source>
        <translation>Den aufgezeichneten Weg noch einmal fahren, so schnell wie damals</translation>
    </message>
    <message>
        <source>Place on the recorded path</source>
        <translation>Ort auf dem aufgezeichneten Weg</translation>
    </message>
    <message>
        <source>Go to any pose of the recorded path</source>
        <translation>Zu jeder Stelle des aufgezeichneten Wegs gehen</translation>
    </message>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhoneRemote</name>
    <message>
        <source>Could not listen at %1: %2.</source>
        <translation>Unter %1 ist keine Verbindung möglich: %2.</translation>
    </message>
    <message>
        <source>This is not the address that the window shows.</source>
        <translation>Das ist nicht die Adresse, die der Computer anzeigt.</translation>
    </message>
    <message>
        <source>This device is not paired.</source>
        <translation>Dieses Gerät ist nicht gekoppelt.</translation>
    </message>
    <message>
        <source>The code is wrong.</source>
        <translation>Der Code ist falsch.</translation>
    </message>
    <message>
        <source>There were too many wrong codes. Make a new code in the window.</source>
        <translation>Es gab zu viele falsche Codes. Erzeugen Sie am Computer einen neuen.</translation>
    </message>
    <message>
        <source>Another device is the remote. Let go of it in the window first.</source>
        <translation>Ein anderes Gerät ist die Fernbedienung. Trennen Sie es zuerst am Computer.</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of the language of these words</comment>
        <translation>de</translation>
    </message>
    <message>
        <source>Spherewalk: remote</source>
        <translation>Spherewalk: Fernbedienung</translation>
    </message>
    <message>
        <source>Pair this device</source>
        <translation>Dieses Gerät koppeln</translation>
    </message>
    <message>
        <source>Type the code that the window on the computer shows.</source>
        <translation>Geben Sie den Code ein, den der Computer anzeigt.</translation>
    </message>
    <message>
        <source>Code of six digits</source>
        <translation>Code aus sechs Ziffern</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Koppeln</translation>
    </message>
    <message>
        <source>Last photo</source>
        <translation>Letztes Foto</translation>
    </message>
    <message>
        <source>No photo yet.</source>
        <translation>Noch kein Foto.</translation>
    </message>
    <message>
        <source>Take it again</source>
        <translation>Noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>No connection to the computer. Trying again...</source>
        <translation>Keine Verbindung zum Computer. Neuer Versuch...</translation>
    </message>
    <message>
        <source>The press did not reach the computer. Press again.</source>
        <translation>Der Tastendruck kam nicht an. Drücken Sie noch einmal.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhotoMover</name>
    <message>
        <source>The two photos cannot be compared before they are aligned: nothing tells how one is turned against the other.</source>
        <translation>Die zwei Fotos sind erst nach dem Ausrichten zu vergleichen: nichts sagt, wie eines gegen das andere gedreht ist.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhotoReviewer</name>
    <message numerus="yes">
        <source>Accept %n photo(s)</source>
        <translation>
            <numerusform>%n Foto annehmen</numerusform>
            <numerusform>%n Fotos annehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reject %n photo(s)</source>
        <translation>
            <numerusform>%n Foto ablehnen</numerusform>
            <numerusform>%n Fotos ablehnen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reopen %n photo(s)</source>
        <translation>
            <numerusform>%n Foto wieder öffnen</numerusform>
            <numerusform>%n Fotos wieder öffnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Note on a photo</source>
        <translation>Notiz zu einem Foto</translation>
    </message>
    <message>
        <source>Hide a region</source>
        <translation>Bereich verbergen</translation>
    </message>
    <message>
        <source>Remove a region</source>
        <translation>Bereich entfernen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlacePanel</name>
    <message>
        <source>The place for other programs</source>
        <translation>Der Ort für andere Programme</translation>
    </message>
    <message>
        <source>Points (PLY)</source>
        <translation>Punkte (PLY)</translation>
    </message>
    <message>
        <source>Every vertex with colour, normal, and how many photos show it</source>
        <translation>Jeder Punkt mit Farbe, Normale und der Zahl der Fotos, die ihn zeigen</translation>
    </message>
    <message>
        <source>Mesh (glTF)</source>
        <translation>Netz (glTF)</translation>
    </message>
    <message>
        <source>One file that viewers and game engines open</source>
        <translation>Eine Datei, die Betrachter und Spiele-Engines öffnen</translation>
    </message>
    <message>
        <source>Mesh (OBJ)</source>
        <translation>Netz (OBJ)</translation>
    </message>
    <message>
        <source>The same as text</source>
        <translation>Dasselbe als Text</translation>
    </message>
    <message>
        <source>Map for robots</source>
        <translation>Karte für Roboter</translation>
    </message>
    <message>
        <source>Where a robot can drive, as Nav2 and map_server read it</source>
        <translation>Wo ein Roboter fahren kann, wie Nav2 und map_server es lesen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Stop; nothing is written then</source>
        <translation>Anhalten; dann wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Seinen Ordner öffnen</translation>
    </message>
    <message>
        <source>A dataset with the depths of two photos or more is needed: export one with depth as its scene model.</source>
        <translation>Nötig ist ein Datensatz mit Tiefen von mindestens zwei Fotos: exportieren Sie einen mit Tiefe als Szenenmodell.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlacePresenter</name>
    <message>
        <source>Writing the place of %1</source>
        <translation>Der Ort von %1 wird geschrieben</translation>
    </message>
    <message>
        <source>%1: %L2 m² of surfaces. From the photos there is a surface in %L3 % of all directions; the rest are holes. Two photos or more show %L4 % of it.</source>
        <translation>%1: %L2 m² Oberflächen. Von den Fotos aus liegt in %L3 % aller Richtungen eine Oberfläche; der Rest sind Löcher. Zwei oder mehr Fotos zeigen %L4 % davon.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; es wurde nichts geschrieben.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanCanvas</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Plan of the room</source>
        <translation>Plan des Raums</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanEditor</name>
    <message>
        <source>Move corner</source>
        <translation>Ecke verschieben</translation>
    </message>
    <message>
        <source>Move outline</source>
        <translation>Umriss verschieben</translation>
    </message>
    <message>
        <source>Move obstacle</source>
        <translation>Hindernis verschieben</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Ecke hinzufügen</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Ecke entfernen</translation>
    </message>
    <message>
        <source>Remove obstacle</source>
        <translation>Hindernis entfernen</translation>
    </message>
    <message>
        <source>Draw outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
    <message>
        <source>Add obstacle</source>
        <translation>Hindernis hinzufügen</translation>
    </message>
    <message>
        <source>Remove the room&apos;s name</source>
        <translation>Namen des Raums entfernen</translation>
    </message>
    <message>
        <source>Name room</source>
        <translation>Raum benennen</translation>
    </message>
    <message>
        <source>Lay rail</source>
        <translation>Schiene legen</translation>
    </message>
    <message>
        <source>Split rail</source>
        <translation>Schiene teilen</translation>
    </message>
    <message>
        <source>Remove rail</source>
        <translation>Schiene entfernen</translation>
    </message>
    <message>
        <source>Remove stop</source>
        <translation>Halt entfernen</translation>
    </message>
    <message>
        <source>Lock rail</source>
        <translation>Schiene feststellen</translation>
    </message>
    <message>
        <source>Unlock rail</source>
        <translation>Schiene lösen</translation>
    </message>
    <message>
        <source>Lay rails anew</source>
        <translation>Schienen neu legen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanEditorView</name>
    <message>
        <source>%L1 m² not covered</source>
        <translation>%L1 m² nicht abgedeckt</translation>
    </message>
    <message>
        <source>%L1 m</source>
        <translation>%L1 m</translation>
    </message>
    <message>
        <source>%1 m, then Return</source>
        <translation>%1 m, dann Eingabe</translation>
    </message>
    <message>
        <source>Drawing of the room</source>
        <translation>Zeichnung des Raums</translation>
    </message>
    <message>
        <source>Click corner after corner, or type a wall&apos;s length and press Return. Close on the first corner, or with a double click.</source>
        <translation>Klicken Sie Ecke für Ecke, oder tippen Sie die Länge einer Wand und drücken Sie Eingabe. Geschlossen wird auf der ersten Ecke oder mit einem Doppelklick.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know.</source>
        <translation>Ziehen Sie an etwas entlang, dessen Länge Sie kennen.</translation>
    </message>
    <message>
        <source>Drag a corner on the picture to the corner where it belongs.</source>
        <translation>Ziehen Sie eine Ecke auf dem Bild zu der Ecke, an die sie gehört.</translation>
    </message>
    <message>
        <source>Drag a second corner to its place: the picture turns and scales around the first.</source>
        <translation>Ziehen Sie eine zweite Ecke an ihren Ort: das Bild dreht und streckt sich um die erste.</translation>
    </message>
    <message>
        <source>Click into a room to name it, or on a name to change it.</source>
        <translation>Klicken Sie in einen Raum, um ihn zu benennen, oder auf einen Namen, um ihn zu ändern.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanMode</name>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Draw the room and lay out where photos are to be taken</source>
        <translation>Den Raum zeichnen und festlegen, wo Fotos aufgenommen werden</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move corners and obstacles</source>
        <translation>Ecken und Hindernisse bewegen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Draw the outline of the room anew</source>
        <translation>Den Umriss des Raums neu zeichnen</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>Draw something that stands on the floor</source>
        <translation>Etwas zeichnen, das auf dem Boden steht</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Draw a known length on the picture</source>
        <translation>Eine bekannte Länge auf das Bild zeichnen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Move, turn and scale the picture by two of its corners</source>
        <translation>Das Bild an zwei seiner Ecken verschieben, drehen und strecken</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Bring the whole room into sight (0)</source>
        <translation>Den ganzen Raum zeigen (0)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Lay a floor plan under the drawing, or take it away</source>
        <translation>Einen Grundriss unter die Zeichnung legen oder wegnehmen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Write the marking-out sheet: the plan to scale with tape distances, as PDF</source>
        <translation>Den Absteckplan schreiben: den Plan im Maßstab mit Bandmaßen, als PDF</translation>
    </message>
    <message>
        <source>The line is this long:</source>
        <translation>Der Strich ist so lang:</translation>
    </message>
    <message>
        <source>Length of the line</source>
        <translation>Länge des Strichs</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Maßstab setzen</translation>
    </message>
    <message>
        <source>The plan is fixed</source>
        <translation>Der Plan steht fest</translation>
    </message>
    <message>
        <source>Photos stand on this plan, or another program writes the survey.</source>
        <translation>Fotos stehen auf diesem Plan, oder ein anderes Programm schreibt das Projekt.</translation>
    </message>
    <message>
        <source>New survey with this room</source>
        <translation>Neues Projekt mit diesem Raum</translation>
    </message>
    <message>
        <source>Use step</source>
        <translation>Schritt verwenden</translation>
    </message>
    <message>
        <source>Stored.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Storing...</source>
        <translation>Wird gespeichert...</translation>
    </message>
    <message>
        <source>Floor plan</source>
        <translation>Grundriss</translation>
    </message>
    <message>
        <source>Pictures and maps (*.png *.jpg *.jpeg *.svg *.bmp *.pgm *.pdf *.yaml *.yml)</source>
        <translation>Bilder und Karten (*.png *.jpg *.jpeg *.svg *.bmp *.pgm *.pdf *.yaml *.yml)</translation>
    </message>
    <message>
        <source>There is no picture to scale; choose one first.</source>
        <translation>Es gibt kein Bild, das einen Maßstab haben könnte; wählen Sie zuerst eins.</translation>
    </message>
    <message>
        <source>Marking-out sheet</source>
        <translation>Absteckplan</translation>
    </message>
    <message>
        <source>marking-out.pdf</source>
        <translation>absteckplan.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 geschrieben.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name the rooms of a flat</source>
        <translation>Die Räume einer Wohnung benennen</translation>
    </message>
    <message>
        <source>Name of the room</source>
        <translation>Name des Raums</translation>
    </message>
    <message>
        <source>What is this room called?</source>
        <translation>Wie heißt dieser Raum?</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Schienen</translation>
    </message>
    <message>
        <source>Move, turn, lengthen, add and remove rails by hand</source>
        <translation>Schienen von Hand verschieben, drehen, verlängern, hinzufügen und entfernen</translation>
    </message>
    <message>
        <source>Remove the selected corner, obstacle, stop or rail (Delete)</source>
        <translation>Die gewählte Ecke, das Hindernis, den Halt oder die Schiene entfernen (Entf)</translation>
    </message>
    <message>
        <source>Nobody has drawn this room: the rectangle is only to begin with. Draw it as it is; without that, an export with depth finds it in the photos.</source>
        <translation>Diesen Raum hat niemand gezeichnet: Das Rechteck ist nur ein Anfang. Zeichnen Sie ihn, wie er ist; sonst findet ihn ein Export mit Tiefe in den Fotos.</translation>
    </message>
    <message>
        <source>Stored. Align keeps the room as you drew it.</source>
        <translation>Gespeichert. Beim Ausrichten bleibt der Raum, wie Sie ihn gezeichnet haben.</translation>
    </message>
    <message>
        <source>The room is what the photos show. If you draw it as it is, Align keeps it so.</source>
        <translation>Der Raum ist, was die Fotos zeigen. Zeichnen Sie ihn, wie er ist, dann bleibt er beim Ausrichten so.</translation>
    </message>
    <message>
        <source>Nobody knows where the photos stand. Align finds that out from the pictures alone; then their room can be drawn.</source>
        <translation>Niemand weiß, wo die Fotos stehen. Ausrichten findet es allein aus den Bildern heraus; dann kann ihr Raum gezeichnet werden.</translation>
    </message>
    <message>
        <source>These rails are a proposal: nothing of it is stored before you change something.</source>
        <translation>Diese Schienen sind ein Vorschlag: Nichts davon wird gespeichert, bevor Sie etwas ändern.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanPanel</name>
    <message>
        <source>What it comes to</source>
        <translation>Was es ergibt</translation>
    </message>
    <message>
        <source>Change number</source>
        <translation>Zahl ändern</translation>
    </message>
    <message>
        <source>Grid and rail</source>
        <translation>Raster und Schiene</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>S&amp;chrittweite</translation>
    </message>
    <message>
        <source>Between neighbouring stations, in both directions.</source>
        <translation>Zwischen benachbarten Standorten, in beiden Richtungen.</translation>
    </message>
    <message>
        <source>&amp;Rail length</source>
        <translation>&amp;Schienenlänge</translation>
    </message>
    <message>
        <source>From the first to the last stop of the cart.</source>
        <translation>Vom ersten zum letzten Halt des Wagens.</translation>
    </message>
    <message>
        <source>Cle&amp;arance</source>
        <translation>Wandabs&amp;tand</translation>
    </message>
    <message>
        <source>Least distance from a stop to walls and obstacles.</source>
        <translation>Kleinster Abstand eines Halts von Wänden und Hindernissen.</translation>
    </message>
    <message>
        <source>Len&amp;s height (m)</source>
        <translation>&amp;Objektivhöhe (m)</translation>
    </message>
    <message>
        <source>Of the lens above the floor; several heights, separated by semicolons, make layers.</source>
        <translation>Des Objektivs über dem Boden; mehrere Höhen, durch Semikolon getrennt, ergeben Schichten.</translation>
    </message>
    <message>
        <source>Ceilin&amp;g</source>
        <translation>Dec&amp;kenhöhe</translation>
    </message>
    <message>
        <source>Height of the ceiling above the floor.</source>
        <translation>Höhe der Decke über dem Boden.</translation>
    </message>
    <message>
        <source>Time a &amp;photo</source>
        <translation>Zeit je &amp;Foto</translation>
    </message>
    <message>
        <source>With moving the cart to the next stop.</source>
        <translation>Mit der Fahrt des Wagens zum nächsten Halt.</translation>
    </message>
    <message>
        <source>Time a rai&amp;l</source>
        <translation>Zeit je Schi&amp;ene</translation>
    </message>
    <message>
        <source>Carrying the rail and laying it anew.</source>
        <translation>Die Schiene tragen und neu legen.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message numerus="yes">
        <source>%n stop(s)</source>
        <translation>
            <numerusform>%n Halt</numerusform>
            <numerusform>%n Halte</numerusform>
        </translation>
    </message>
    <message>
        <source>Corners of obstacle %1</source>
        <translation>Ecken von Hindernis %1</translation>
    </message>
    <message>
        <source>Corners of the room</source>
        <translation>Ecken des Raums</translation>
    </message>
    <message>
        <source>Photos by hand, of unknown places</source>
        <translation>Fotos von Hand, Orte unbekannt</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanStorage</name>
    <message>
        <source>The plan is not stored: %1</source>
        <translation>Der Plan ist nicht gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanView</name>
    <message>
        <source>No survey is open</source>
        <translation>Kein Projekt ist offen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanWords</name>
    <message>
        <source>closer than %L1 m to a wall or an obstacle</source>
        <translation>näher als %L1 m an einer Wand oder einem Hindernis</translation>
    </message>
    <message>
        <source>cut off by obstacles</source>
        <translation>durch Hindernisse abgeschnitten</translation>
    </message>
    <message>
        <source>no stop falls near enough</source>
        <translation>kein Halt liegt nah genug</translation>
    </message>
    <message numerus="yes">
        <source>%n station(s)</source>
        <translation>
            <numerusform>%n Standort</numerusform>
            <numerusform>%n Standorte</numerusform>
        </translation>
    </message>
    <message>
        <source> on </source>
        <translation> auf </translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s)</source>
        <translation>
            <numerusform>%n Schiene</numerusform>
            <numerusform>%n Schienen</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 m to walk, about %2</source>
        <translation>%L1 m zu gehen, etwa %2</translation>
    </message>
    <message>
        <source>%L1 m² of floor, %L2 m² not covered (%3 %)</source>
        <translation>%L1 m² Boden, %L2 m² nicht abgedeckt (%3 %)</translation>
    </message>
    <message>
        <source>%L1 m²: %2</source>
        <translation>%L1 m²: %2</translation>
    </message>
    <message>
        <source>Marking out: %1</source>
        <translation>Absteckplan: %1</translation>
    </message>
    <message>
        <source>%1 stations on %2 rails; step %3 cm; rail of %4 stops, %5 m</source>
        <translation>%1 Standorte auf %2 Schienen; Schritt %3 cm; Schiene mit %4 Halten, %5 m</translation>
    </message>
    <message>
        <source>Scale 1:%1. Print at 100 %: this bar is 10 cm long.</source>
        <translation>Maßstab 1:%1. Mit 100 % drucken: dieser Balken ist 10 cm lang.</translation>
    </message>
    <message>
        <source>Where the rails lie: metres by tape</source>
        <translation>Wo die Schienen liegen: Meter mit dem Bandmaß</translation>
    </message>
    <message>
        <source>Error: how far a place is off at most if each tape is read wrong by 5 mm. Below: check and laser.</source>
        <translation>Fehler: wie weit ein Ort höchstens danebenliegt, wenn jedes Band um 5 mm falsch gelesen wird. Darunter: Probe und Laser.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Halte</translation>
    </message>
    <message>
        <source>First stop (ring)</source>
        <translation>Erster Halt (Ring)</translation>
    </message>
    <message>
        <source>Last stop (arrow)</source>
        <translation>Letzter Halt (Pfeil)</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>nothing in sight to measure from</source>
        <translation>nichts in Sicht, von dem zu messen wäre</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>Probe %1</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>Ring %1</translation>
    </message>
    <message>
        <source>arrow %1</source>
        <translation>Pfeil %1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) by hand</source>
        <translation>
            <numerusform>%n Foto von Hand</numerusform>
            <numerusform>%n Fotos von Hand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewFeed</name>
    <message>
        <source>The camera sent no picture; start the preview again.</source>
        <translation>Die Kamera hat kein Bild geschickt; starten Sie das Live-Bild erneut.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewMode</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Drive a robot and see what its camera would see</source>
        <translation>Einen Roboter fahren und sehen, was seine Kamera sähe</translation>
    </message>
    <message>
        <source>Where the robot is</source>
        <translation>Wo der Roboter ist</translation>
    </message>
    <message>
        <source>&amp;Preview this survey</source>
        <translation>Dieses Projekt &amp;zeigen</translation>
    </message>
    <message>
        <source>Export the survey to a temporary folder and look at it; nothing is kept</source>
        <translation>Das Projekt in einen vorläufigen Ordner exportieren und ansehen; nichts bleibt</translation>
    </message>
    <message>
        <source>Open a &amp;dataset...</source>
        <translation>Datensatz ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Look at a dataset that was exported before</source>
        <translation>Einen früher exportierten Datensatz ansehen</translation>
    </message>
    <message>
        <source>&amp;With depth</source>
        <translation>&amp;Mit Tiefe</translation>
    </message>
    <message>
        <source>The depth of each pixel follows while you drive, in surveys of up to %1 photos</source>
        <translation>Die Tiefe jedes Pixels folgt, während Sie fahren, bei Projekten bis %1 Fotos</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Aufzei&amp;chnen</translation>
    </message>
    <message>
        <source>Record the path that the robot takes</source>
        <translation>Den Weg des Roboters aufzeichnen</translation>
    </message>
    <message>
        <source>&amp;Save frames...</source>
        <translation>Bilder &amp;speichern...</translation>
    </message>
    <message>
        <source>Render a frame at each pose of the recorded path, as the command walk does</source>
        <translation>An jeder Stelle des aufgezeichneten Wegs ein Bild berechnen, wie der Befehl walk</translation>
    </message>
    <message>
        <source>Scene model of view %1</source>
        <translation>Szenenmodell der Ansicht %1</translation>
    </message>
    <message>
        <source>What places between photos are computed with, cheap to exact</source>
        <translation>Womit Orte zwischen Fotos berechnet werden, billig bis genau</translation>
    </message>
    <message>
        <source>None: nearest photo, turned</source>
        <translation>Keins: nächstes Foto, gedreht</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Room: walls, floor, ceiling</source>
        <translation>Raum: Wände, Boden, Decke</translation>
    </message>
    <message>
        <source>Depth of each pixel</source>
        <translation>Tiefe jedes Pixels</translation>
    </message>
    <message>
        <source>Blend: depth, photos mixed</source>
        <translation>Mischung: Tiefe, Fotos gemischt</translation>
    </message>
    <message>
        <source>Sampling of view %1</source>
        <translation>Abtastung der Ansicht %1</translation>
    </message>
    <message>
        <source>How pixels are made, cheap to exact</source>
        <translation>Wie Pixel entstehen, billig bis genau</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nächster</translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation>Bilinear</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>Fußabdruck</translation>
    </message>
    <message>
        <source>Bicubic</source>
        <translation>Bikubisch</translation>
    </message>
    <message>
        <source>Camera and view</source>
        <translation>Kamera und Ansicht</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source> m high</source>
        <translation> m hoch</translation>
    </message>
    <message>
        <source>Height of the camera above the floor</source>
        <translation>Höhe der Kamera über dem Boden</translation>
    </message>
    <message>
        <source>° down</source>
        <translation>° abwärts</translation>
    </message>
    <message>
        <source>How far the camera looks below the horizon</source>
        <translation>Wie weit die Kamera unter den Horizont sieht</translation>
    </message>
    <message>
        <source>Carried</source>
        <translation>Getragen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>Show a second view beside the first, made another way</source>
        <translation>Daneben eine zweite Ansicht zeigen, die anders entsteht</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Sh&amp;ow the expected error</source>
        <translation>Er&amp;warteten Fehler zeigen</translation>
    </message>
    <message>
        <source>Tints what is displaced: light from half a pixel on, dark at %1 pixels and more</source>
        <translation>Färbt, was verschoben ist: hell ab einem halben Pixel, dunkel ab %1 Pixeln</translation>
    </message>
    <message>
        <source>Open a dataset</source>
        <translation>Einen Datensatz öffnen</translation>
    </message>
    <message>
        <source>Folder for the frames</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>Preparing the preview...</source>
        <translation>Die Vorschau wird vorbereitet...</translation>
    </message>
    <message>
        <source>No dataset is open.</source>
        <translation>Kein Datensatz ist offen.</translation>
    </message>
    <message>
        <source>%1: the survey has changed since; preview it again.</source>
        <translation>%1: das Projekt hat sich seither geändert; zeigen Sie es erneut.</translation>
    </message>
    <message>
        <source>%1: a sphere stands for the room; depth follows.</source>
        <translation>%1: eine Kugel steht für den Raum; die Tiefe folgt.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s)</source>
        <translation>
            <numerusform>%1: %n Foto</numerusform>
            <numerusform>%1: %n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 views/s</source>
        <translation>%1 Ansichten/s</translation>
    </message>
    <message numerus="yes">
        <source>● %n pose(s)</source>
        <translation>
            <numerusform>● %n Stelle</numerusform>
            <numerusform>● %n Stellen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (dataset)</source>
        <translation>%1 (Datensatz)</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) in the dataset</source>
        <translation>
            <numerusform>%n Foto im Datensatz</numerusform>
            <numerusform>%n Fotos im Datensatz</numerusform>
        </translation>
    </message>
    <message>
        <source>Its camera</source>
        <translation>Ihre Kamera</translation>
    </message>
    <message>
        <source>Give the second view another camera than the first</source>
        <translation>Der zweiten Ansicht eine andere Kamera geben als der ersten</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Kamera der Ansicht %1</translation>
    </message>
    <message>
        <source>The robot&apos;s own pictures...</source>
        <translation>Eigene Bilder des Roboters...</translation>
    </message>
    <message>
        <source>Show what the robot&apos;s camera took beside the view: a CSV file with the columns file, x_m, y_m, z_m, qw, qx, qy, qz</source>
        <translation>Neben der Ansicht zeigen, was die Kamera des Roboters aufgenommen hat: eine CSV-Datei mit den Spalten file, x_m, y_m, z_m, qw, qx, qy, qz</translation>
    </message>
    <message>
        <source>Poses of the robot&apos;s own pictures</source>
        <translation>Posen der eigenen Bilder des Roboters</translation>
    </message>
    <message>
        <source>Positions (*.csv)</source>
        <translation>Positionen (*.csv)</translation>
    </message>
    <message>
        <source>Click to put the robot there, drag to turn it; with Shift, put the object there</source>
        <translation>Klicken stellt den Roboter dorthin, Ziehen dreht ihn; mit Umschalt wird das Objekt dorthin gestellt</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), without depth.</source>
        <translation>
            <numerusform>%1: %n Foto, ohne Tiefe.</numerusform>
            <numerusform>%1: %n Fotos, ohne Tiefe.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is previewed yet.</source>
        <translation>Noch keine Vorschau.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewPresenter</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>There is no photo to preview yet; capture or import some first.</source>
        <translation>Es gibt noch kein Foto zu zeigen; nehmen Sie welche auf, oder importieren Sie sie.</translation>
    </message>
    <message>
        <source>Preparing the preview of %1</source>
        <translation>Die Vorschau von %1 wird vorbereitet</translation>
    </message>
    <message>
        <source>Depth for the preview of %1</source>
        <translation>Tiefe für die Vorschau von %1</translation>
    </message>
    <message>
        <source>There is no path to save; record one first.</source>
        <translation>Es gibt keinen Weg zu speichern; zeichnen Sie zuerst einen auf.</translation>
    </message>
    <message numerus="yes">
        <source>Saving %n frame(s)</source>
        <translation>
            <numerusform>%n Bild wird gespeichert</numerusform>
            <numerusform>%n Bilder werden gespeichert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n frame(s) to %1.</source>
        <translation>
            <numerusform>%n Bild nach %1 geschrieben.</numerusform>
            <numerusform>%n Bilder nach %1 geschrieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>How far away that is is not known; click at another place.</source>
        <translation>Wie weit das entfernt ist, ist nicht bekannt; klicken Sie woanders hin.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewView</name>
    <message>
        <source>The preview rests while a picture is taken.</source>
        <translation>Das Live-Bild ruht, während ein Foto aufgenommen wird.</translation>
    </message>
    <message>
        <source>Waiting for the camera&apos;s first picture...</source>
        <translation>Warten auf das erste Bild der Kamera...</translation>
    </message>
    <message>
        <source>The camera has ended its preview.</source>
        <translation>Die Kamera hat ihr Live-Bild beendet.</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>Was die Kamera sieht</translation>
    </message>
    <message>
        <source>%L1 % white</source>
        <translation>%L1 % weiß</translation>
    </message>
    <message>
        <source>%L1 % black</source>
        <translation>%L1 % schwarz</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ProfileForm</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>shade</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>cloudy</source>
        <translation>bewölkt</translation>
    </message>
    <message>
        <source>incandescent</source>
        <translation>Glühlampe</translation>
    </message>
    <message>
        <source>fluorescent, white</source>
        <translation>Leuchtstoff, weiß</translation>
    </message>
    <message>
        <source>fluorescent, warm white</source>
        <translation>Leuchtstoff, warmweiß</translation>
    </message>
    <message>
        <source>fluorescent, daylight</source>
        <translation>Leuchtstoff, Tageslicht</translation>
    </message>
    <message>
        <source>fluorescent, day white</source>
        <translation>Leuchtstoff, tagesweiß</translation>
    </message>
    <message>
        <source>fluorescent bulb</source>
        <translation>Energiesparlampe</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>EV</source>
        <translation>EV</translation>
    </message>
    <message>
        <source>as the camera is set</source>
        <translation>wie die Kamera eingestellt ist</translation>
    </message>
    <message>
        <source>Leave it as the camera is set</source>
        <translation>So lassen, wie die Kamera eingestellt ist</translation>
    </message>
    <message>
        <source>Exposure of the photos</source>
        <translation>Belichtung der Fotos</translation>
    </message>
    <message>
        <source>Photos of one room fit each other best if all are exposed alike: fix ISO, shutter time and white balance where the light does not change.</source>
        <translation>Fotos eines Raums passen am besten zusammen, wenn alle gleich belichtet sind: legen Sie ISO, Belichtungszeit und Weißabgleich fest, wo sich das Licht nicht ändert.</translation>
    </message>
    <message>
        <source>&amp;ISO</source>
        <translation>&amp;ISO</translation>
    </message>
    <message>
        <source>Fixed, or chosen by the camera for each photo.</source>
        <translation>Fest, oder für jedes Foto von der Kamera gewählt.</translation>
    </message>
    <message>
        <source>&amp;Shutter time</source>
        <translation>Belichtungs&amp;zeit</translation>
    </message>
    <message>
        <source>&amp;Brightness</source>
        <translation>&amp;Helligkeit</translation>
    </message>
    <message>
        <source>How much brighter or darker than the camera thinks right.</source>
        <translation>Wie viel heller oder dunkler, als die Kamera für richtig hält.</translation>
    </message>
    <message>
        <source>&amp;White balance</source>
        <translation>&amp;Weißabgleich</translation>
    </message>
    <message>
        <source>The colour of the light.</source>
        <translation>Die Farbe des Lichts.</translation>
    </message>
    <message>
        <source>&amp;Photo size</source>
        <translation>&amp;Fotogröße</translation>
    </message>
    <message>
        <source>Of those that the camera offers.</source>
        <translation>Von denen, die die Kamera anbietet.</translation>
    </message>
    <message>
        <source>&amp;Keep what the camera chose last: %1</source>
        <translation>&amp;Behalten, was die Kamera zuletzt wählte: %1</translation>
    </message>
    <message>
        <source>&amp;Keep what the camera chose last</source>
        <translation>&amp;Behalten, was die Kamera zuletzt wählte</translation>
    </message>
    <message>
        <source>ISO and shutter time of the latest photo of this survey.</source>
        <translation>ISO und Belichtungszeit des letzten Fotos dieses Projekts.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RailPanel</name>
    <message>
        <source>Rails</source>
        <translation>Schienen</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Make two rails of it, the second from the selected stop on</source>
        <translation>Zwei Schienen daraus machen, die zweite ab dem gewählten Halt</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Feststellen</translation>
    </message>
    <message>
        <source>Keep the rail where it is, also when others are laid anew</source>
        <translation>Die Schiene lassen, wo sie ist, auch wenn andere neu gelegt werden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected stop or rail (Delete)</source>
        <translation>Den gewählten Halt oder die Schiene entfernen (Entf)</translation>
    </message>
    <message>
        <source>Lay the others anew</source>
        <translation>Die anderen neu legen</translation>
    </message>
    <message>
        <source>Keep the locked rails, and lay out the rest of the floor around them</source>
        <translation>Die festgestellten Schienen lassen und den übrigen Boden um sie herum planen</translation>
    </message>
    <message>
        <source>The program laid all rails.</source>
        <translation>Das Programm hat alle Schienen gelegt.</translation>
    </message>
    <message numerus="yes">
        <source>The program laid the rest around %n locked rail(s).</source>
        <translation>
            <numerusform>Das Programm hat den Rest um %n festgestellte Schiene gelegt.</numerusform>
            <numerusform>Das Programm hat den Rest um %n festgestellte Schienen gelegt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Laid by hand; %n of them locked.</source>
        <translation>
            <numerusform>Von Hand gelegt; %n davon ist festgestellt.</numerusform>
            <numerusform>Von Hand gelegt; %n davon sind festgestellt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rail %1: %n stop(s), %L2 m, heading %3°</source>
        <translation>
            <numerusform>Schiene %1: %n Halt, %L2 m, Richtung %3°</numerusform>
            <numerusform>Schiene %1: %n Halte, %L2 m, Richtung %3°</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Lösen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RailTool</name>
    <message>
        <source>Drag a rail to move it, its first or last stop to turn and lengthen it (Shift: without a turn), or free floor to lay a rail. Ctrl+arrows turn it or change its length; Delete removes a stop or a rail.</source>
        <translation>Ziehen Sie an einer Schiene, um sie zu verschieben, an ihrem ersten oder letzten Halt, um sie zu drehen und zu verlängern (Umschalt: ohne Drehung), oder über freien Boden, um eine zu legen. Strg+Pfeile drehen sie oder ändern ihre Länge; Entf entfernt einen Halt oder eine Schiene.</translation>
    </message>
    <message>
        <source>Pull rail</source>
        <translation>An der Schiene ziehen</translation>
    </message>
    <message>
        <source>Move rail</source>
        <translation>Schiene verschieben</translation>
    </message>
    <message>
        <source>Turn rail</source>
        <translation>Schiene drehen</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>Länge ändern</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RecentSurveys</name>
    <message>
        <source>%1 of %2 photos, %3</source>
        <translation>%1 von %2 Fotos, %3</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RegionBar</name>
    <message>
        <source>Hide a region</source>
        <translation>Bereich verbergen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>As e&amp;xported</source>
        <translation>&amp;Wie exportiert</translation>
    </message>
    <message>
        <source>Put a box around a face, a screen or a sheet of paper: exports show it blurred (%1)</source>
        <translation>Einen Rahmen um ein Gesicht, einen Bildschirm oder ein Blatt Papier legen: Exporte zeigen es unkenntlich (%1)</translation>
    </message>
    <message>
        <source>Remove the selected region</source>
        <translation>Den gewählten Bereich entfernen</translation>
    </message>
    <message>
        <source>Let exports show the selected region again (Delete in the photo); click or Tab selects one</source>
        <translation>Den gewählten Bereich in Exporten wieder zeigen (Entf im Foto); Klick oder Tab wählt einen</translation>
    </message>
    <message>
        <source>Show the photo as exports have it, with its private regions blurred</source>
        <translation>Das Foto so zeigen, wie Exporte es haben, mit unkenntlichen privaten Bereichen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RemoteForm</name>
    <message>
        <source>Phone as remote</source>
        <translation>Telefon als Fernbedienung</translation>
    </message>
    <message>
        <source>This computer&apos;s address in the network that the phone is in, too.</source>
        <translation>Adresse dieses Computers in dem Netz, in dem auch das Telefon ist.</translation>
    </message>
    <message>
        <source>Nothing is encrypted on the way: whoever can listen in this network can read along and take the remote over. Use a network that you trust, and turn the remote off when you are done.</source>
        <translation>Unterwegs ist nichts verschlüsselt: Wer in diesem Netz mithören kann, kann mitlesen und die Fernbedienung übernehmen. Nutzen Sie ein Netz, dem Sie vertrauen, und schalten Sie die Fernbedienung aus, wenn Sie fertig sind.</translation>
    </message>
    <message>
        <source>A phone or tablet on the cart shows the next station, shoots, and shows the last photo. Open the address in its browser, and type the code there.</source>
        <translation>Ein Telefon oder Tablet auf dem Wagen zeigt den nächsten Standort, löst aus und zeigt das letzte Foto. Öffnen Sie die Adresse in seinem Browser, und geben Sie dort den Code ein.</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>&amp;Netz:</translation>
    </message>
    <message>
        <source>Address:</source>
        <translation>Adresse:</translation>
    </message>
    <message>
        <source>Code:</source>
        <translation>Code:</translation>
    </message>
    <message>
        <source>This computer is in no local network. Connect it to the network that the phone is in.</source>
        <translation>Dieser Computer ist in keinem lokalen Netz. Verbinden Sie ihn mit dem Netz, in dem das Telefon ist.</translation>
    </message>
    <message>
        <source>The device at %1 is the remote.</source>
        <translation>Das Gerät mit der Adresse %1 ist die Fernbedienung.</translation>
    </message>
    <message>
        <source>Wrong codes came too often, and the code is void. Make a new one.</source>
        <translation>Es kamen zu viele falsche Codes, und der Code ist ungültig. Erzeugen Sie einen neuen.</translation>
    </message>
    <message>
        <source>No device is paired yet.</source>
        <translation>Noch ist kein Gerät gekoppelt.</translation>
    </message>
    <message>
        <source>&amp;Turn off</source>
        <translation>&amp;Ausschalten</translation>
    </message>
    <message>
        <source>&amp;Turn on</source>
        <translation>&amp;Einschalten</translation>
    </message>
    <message>
        <source>&amp;Let go of the device</source>
        <translation>Gerät &amp;trennen</translation>
    </message>
    <message>
        <source>New &amp;code</source>
        <translation>Neuer &amp;Code</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewDelegate</name>
    <message>
        <source>no photo</source>
        <translation>kein Foto</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>nicht lesbar</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewMode</name>
    <message>
        <source>Review</source>
        <translation>Sichten</translation>
    </message>
    <message>
        <source>Look at the photos, and accept or reject them</source>
        <translation>Die Fotos ansehen und annehmen oder ablehnen</translation>
    </message>
    <message>
        <source>Which stations are listed</source>
        <translation>Welche Standorte gelistet sind</translation>
    </message>
    <message>
        <source>Station, file or note</source>
        <translation>Standort, Datei oder Notiz</translation>
    </message>
    <message>
        <source>Text that listed stations contain</source>
        <translation>Text, den gelistete Standorte enthalten</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Standorte</translation>
    </message>
    <message>
        <source>Accept every photo that the checks and the alignment call good</source>
        <translation>Jedes Foto annehmen, das Prüfungen und Ausrichtung gut nennen</translation>
    </message>
    <message>
        <source>Judge the photos that no check has seen, such as imported ones</source>
        <translation>Die Fotos beurteilen, die noch keine Prüfung gesehen hat, etwa importierte</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>One photo</source>
        <translation>Ein Foto</translation>
    </message>
    <message>
        <source>Blink with</source>
        <translation>Blinken mit</translation>
    </message>
    <message>
        <source>Slider with</source>
        <translation>Schieber mit</translation>
    </message>
    <message>
        <source>How the photo is compared</source>
        <translation>Wie das Foto verglichen wird</translation>
    </message>
    <message>
        <source>Compare the photo with a neighbour: C for the next way</source>
        <translation>Das Foto mit einem Nachbarn vergleichen: C für die nächste Art</translation>
    </message>
    <message>
        <source>Neighbour to compare with</source>
        <translation>Nachbar zum Vergleichen</translation>
    </message>
    <message>
        <source>The neighbour to compare with: N for the next one</source>
        <translation>Der Nachbar zum Vergleichen: N für den nächsten</translation>
    </message>
    <message>
        <source>Align first</source>
        <translation>Erst ausrichten</translation>
    </message>
    <message>
        <source>Photos that are not aligned may be turned differently</source>
        <translation>Fotos, die nicht ausgerichtet sind, können verschieden gedreht sein</translation>
    </message>
    <message>
        <source>Next way to compare</source>
        <translation>Nächste Art zu vergleichen</translation>
    </message>
    <message>
        <source>Next neighbour</source>
        <translation>Nächster Nachbar</translation>
    </message>
    <message>
        <source>Note on this photo (M)</source>
        <translation>Notiz zu diesem Foto (M)</translation>
    </message>
    <message>
        <source>Note on this photo</source>
        <translation>Notiz zu diesem Foto</translation>
    </message>
    <message>
        <source>Write a note</source>
        <translation>Eine Notiz schreiben</translation>
    </message>
    <message>
        <source> Accept</source>
        <translation> Annehmen</translation>
    </message>
    <message>
        <source>Accept the photo and go on</source>
        <translation>Das Foto annehmen und weitergehen</translation>
    </message>
    <message>
        <source> Reject</source>
        <translation> Ablehnen</translation>
    </message>
    <message>
        <source>Reject the photo: it is left out of datasets and is to be taken again</source>
        <translation>Das Foto ablehnen: es kommt in keinen Datensatz und wird neu aufgenommen</translation>
    </message>
    <message>
        <source>Reopen</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Withdraw the decision</source>
        <translation>Die Entscheidung zurücknehmen</translation>
    </message>
    <message>
        <source>Next photo</source>
        <translation>Nächstes Foto</translation>
    </message>
    <message>
        <source>Previous photo</source>
        <translation>Voriges Foto</translation>
    </message>
    <message>
        <source>What the plan shows</source>
        <translation>Was der Plan zeigt</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Residuals of the alignment</source>
        <translation>Reste der Ausrichtung</translation>
    </message>
    <message>
        <source>Uncertainty of the headings</source>
        <translation>Unsicherheit der Richtungen</translation>
    </message>
    <message>
        <source>Measured errors of views</source>
        <translation>Gemessene Fehler von Ansichten</translation>
    </message>
    <message>
        <source>Report...</source>
        <translation>Bericht...</translation>
    </message>
    <message>
        <source>Take the errors from another report.json</source>
        <translation>Die Fehler aus einer anderen report.json nehmen</translation>
    </message>
    <message>
        <source>Report of a measured dataset</source>
        <translation>Bericht eines gemessenen Datensatzes</translation>
    </message>
    <message>
        <source>Report (report.json *.json)</source>
        <translation>Bericht (report.json *.json)</translation>
    </message>
    <message>
        <source>Accept all &amp;good ones (%1)</source>
        <translation>Alle &amp;guten annehmen (%1)</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Check %n photo(s)</source>
        <translation>
            <numerusform>%n Foto &amp;prüfen</numerusform>
            <numerusform>%n Fotos &amp;prüfen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, %2 cm away</source>
        <translation>%1, %2 cm entfernt</translation>
    </message>
    <message>
        <source>Tab, Delete</source>
        <translation>Tab, Entf</translation>
    </message>
    <message>
        <source>In the photo: select a private region, remove it</source>
        <translation>Im Foto: einen privaten Bereich wählen, ihn entfernen</translation>
    </message>
    <message>
        <source>arrows, Shift+arrows, Return</source>
        <translation>Pfeile, Umschalt+Pfeile, Eingabe</translation>
    </message>
    <message>
        <source>While a region is being hidden: move the box, size it, store it</source>
        <translation>Beim Verbergen eines Bereichs: den Rahmen verschieben, seine Größe ändern, ihn speichern</translation>
    </message>
    <message>
        <source>Contact sheet</source>
        <translation>Übersichtsbogen</translation>
    </message>
    <message>
        <source>Show the listed photos beside each other, in place of one photo and the plan</source>
        <translation>Die gelisteten Fotos nebeneinander zeigen, statt eines Fotos und des Plans</translation>
    </message>
    <message>
        <source>Story</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Tell what became of this photo: taken, judged, moved, aligned, decided</source>
        <translation>Sagen, was mit diesem Foto geschah: aufgenommen, beurteilt, verlegt, ausgerichtet, entschieden</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewModel</name>
    <message>
        <source>%L1 px</source>
        <translation>%L1 px</translation>
    </message>
    <message>
        <source>95 of 100 places of views in its place are displaced by %1 or less.</source>
        <translation>95 von 100 Stellen von Ansichten an seinem Ort sind um höchstens %1 verschoben.</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>More than 5 of 100 places were not found in views in its place.</source>
        <translation>Mehr als 5 von 100 Stellen wurden in Ansichten an seinem Ort nicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n private region(s), which exports show blurred</source>
        <translation>
            <numerusform>%n privater Bereich, den Exporte unkenntlich zeigen</numerusform>
            <numerusform>%n private Bereiche, die Exporte unkenntlich zeigen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewPresenter</name>
    <message>
        <source>The report %1 is of another survey&apos;s dataset, %2.</source>
        <translation>Der Bericht %1 gehört zum Datensatz eines anderen Projekts, %2.</translation>
    </message>
    <message>
        <source>No dataset of this survey has been measured yet: do so in Export, or choose the report.json of one that was.</source>
        <translation>Noch kein Datensatz dieses Projekts wurde gemessen: tun Sie es in Exportieren, oder wählen Sie die report.json eines gemessenen.</translation>
    </message>
    <message>
        <source>Displacement of 95 of 100 places, where the photo was left out of %1; scene model %2, tolerance %L3 px.</source>
        <translation>Verschiebung von 95 von 100 Stellen, wo das Foto aus %1 ausgelassen wurde; Szenenmodell %2, Toleranz %L3 px.</translation>
    </message>
    <message>
        <source>Checking photos</source>
        <translation>Fotos werden geprüft</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) checked: %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>%n Foto geprüft: %1 gut, %2 zweifelhaft, %3 fehlgeschlagen.</numerusform>
            <numerusform>%n Fotos geprüft: %1 gut, %2 zweifelhaft, %3 fehlgeschlagen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 accepted, %2 rejected, %3 to be reviewed, %4 missing</source>
        <translation>%1 angenommen, %2 abgelehnt, %3 zu sichten, %4 fehlen</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) searched</source>
        <translation>
            <numerusform>%n Foto durchsucht</numerusform>
            <numerusform>%n Fotos durchsucht</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: no face found.</source>
        <translation>%1: kein Gesicht gefunden.</translation>
    </message>
    <message>
        <source>%1: %2 %3, which exports show blurred.</source>
        <translation>%1: %2 %3; Exporte zeigen sie unkenntlich.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) found</source>
        <translation>
            <numerusform>%n Gesicht</numerusform>
            <numerusform>%n Gesichter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>in %n Foto</numerusform>
            <numerusform>in %n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>Searching for faces</source>
        <translation>Sucht Gesichter</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RobotMap</name>
    <message>
        <source>No dataset is open</source>
        <translation>Kein Datensatz ist offen</translation>
    </message>
    <message>
        <source>Nothing is previewed yet</source>
        <translation>Noch keine Vorschau</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RungWords</name>
    <message>
        <source>none</source>
        <translation>keins</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>bilinear</source>
        <translation>bilinear</translation>
    </message>
    <message>
        <source>reduced</source>
        <translation>reduziert</translation>
    </message>
    <message>
        <source>footprint</source>
        <translation>Fußabdruck</translation>
    </message>
    <message>
        <source>bicubic</source>
        <translation>bikubisch</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>nach Bedarf</translation>
    </message>
    <message>
        <source>Best there is</source>
        <translation>Das beste vorhandene</translation>
    </message>
    <message>
        <source>Best there is: %1</source>
        <translation>Das beste vorhandene: %1</translation>
    </message>
    <message>
        <source>As measured: %1, cheaper where enough</source>
        <translation>Wie gemessen: %1, billiger, wo es genügt</translation>
    </message>
    <message>
        <source>As measured: %1</source>
        <translation>Wie gemessen: %1</translation>
    </message>
    <message>
        <source>As needed</source>
        <translation>Nach Bedarf</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StartPage</name>
    <message>
        <source>Recent surveys</source>
        <translation>Letzte Projekte</translation>
    </message>
    <message>
        <source>Spherewalk</source>
        <translation>Spherewalk</translation>
    </message>
    <message>
        <source>Scan a room with a spherical camera, and let robots see it.</source>
        <translation>Nehmen Sie einen Raum mit einer Kugelkamera auf, und lassen Sie Roboter ihn sehen.</translation>
    </message>
    <message>
        <source>&amp;Try the practice room</source>
        <translation>Den Übungs&amp;raum ausprobieren</translation>
    </message>
    <message>
        <source>Makes a survey of a room that exists only in the program, and photographs it.</source>
        <translation>Macht ein Projekt eines Raums, den es nur im Programm gibt, und nimmt ihn auf.</translation>
    </message>
    <message>
        <source>No camera is needed: the program has one inside, which photographs a furnished room while you watch. It takes about a minute.</source>
        <translation>Keine Kamera nötig: das Programm hat eine in sich, die einen möblierten Raum aufnimmt, während Sie zusehen. Das dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>&amp;New survey</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>Draw a room and lay out its stations.</source>
        <translation>Einen Raum zeichnen und seine Standorte festlegen.</translation>
    </message>
    <message>
        <source>&amp;Open a survey...</source>
        <translation>Projekt ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>A folder whose name ends in .spherewalk.</source>
        <translation>Ein Ordner, dessen Name auf .spherewalk endet.</translation>
    </message>
    <message>
        <source>Take the tour, in five steps</source>
        <translation>Rundgang in fünf Schritten</translation>
    </message>
    <message>
        <source>Leads through all pages with the practice room.</source>
        <translation>Führt mit dem Übungsraum durch alle Seiten.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StationQueue</name>
    <message>
        <source>%1: %2 of %3 taken</source>
        <translation>%1: %2 von %3 aufgenommen</translation>
    </message>
    <message>
        <source>Photo %1</source>
        <translation>Foto %1</translation>
    </message>
    <message>
        <source>Hold the camera upright and still. Take the next photo about half a metre on.</source>
        <translation>Halten Sie die Kamera aufrecht und still. Nehmen Sie das nächste Foto etwa einen halben Meter weiter auf.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) found their place. Walk on about half a metre.</source>
        <translation>
            <numerusform>%n Foto hat seinen Ort gefunden. Gehen Sie etwa einen halben Meter weiter.</numerusform>
            <numerusform>%n Fotos haben ihren Ort gefunden. Gehen Sie etwa einen halben Meter weiter.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 photos found their place. Take some between the others and these.</source>
        <translation>%1 von %2 Fotos haben ihren Ort gefunden. Nehmen Sie welche zwischen den anderen und diesen auf.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StationWords</name>
    <message>
        <source>ring %1</source>
        <translation>Ring %1</translation>
    </message>
    <message>
        <source>arrow %1</source>
        <translation>Pfeil %1</translation>
    </message>
    <message>
        <source>%1 %L2 m</source>
        <translation>%1 %L2 m</translation>
    </message>
    <message>
        <source>x %L1, y %L2</source>
        <translation>x %L1, y %L2</translation>
    </message>
    <message>
        <source>%1 (check: %2)</source>
        <translation>%1 (Probe: %2)</translation>
    </message>
    <message>
        <source>Rail %1, stop %2</source>
        <translation>Schiene %1, Halt %2</translation>
    </message>
    <message>
        <source>%1, at %L2 m</source>
        <translation>%1, auf %L2 m</translation>
    </message>
    <message>
        <source>x %L1 m, y %L2 m, lens at %L3 m</source>
        <translation>x %L1 m, y %L2 m, Objektiv auf %L3 m</translation>
    </message>
    <message>
        <source>Lay the rail. First stop: %1. Last stop: %2.</source>
        <translation>Legen Sie die Schiene. Erster Halt: %1. Letzter Halt: %2.</translation>
    </message>
    <message>
        <source>Unknown place %1</source>
        <translation>Unbekannter Ort %1</translation>
    </message>
    <message>
        <source>Unknown place of %1</source>
        <translation>Unbekannter Ort von %1</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Ort von %1</translation>
    </message>
    <message>
        <source>At x %L1, y %L2</source>
        <translation>Bei x %L1, y %L2</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StoryWords</name>
    <message>
        <source>Taken %1 as %2</source>
        <translation>Aufgenommen %1 als %2</translation>
    </message>
    <message>
        <source>Taken as %1, it does not say when</source>
        <translation>Aufgenommen als %1, ohne Angabe der Zeit</translation>
    </message>
    <message>
        <source>, by the camera %1</source>
        <translation>, von der Kamera %1</translation>
    </message>
    <message>
        <source>%1%2; stored %3.</source>
        <translation>%1%2; gespeichert %3.</translation>
    </message>
    <message>
        <source>No check has judged it.</source>
        <translation>Keine Prüfung hat es beurteilt.</translation>
    </message>
    <message>
        <source>The checks found nothing.</source>
        <translation>Die Prüfungen fanden nichts.</translation>
    </message>
    <message numerus="yes">
        <source>The checks found %n thing(s).</source>
        <translation>
            <numerusform>Die Prüfungen fanden %n Sache.</numerusform>
            <numerusform>Die Prüfungen fanden %n Sachen.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not aligned yet.</source>
        <translation>Es ist noch nicht ausgerichtet.</translation>
    </message>
    <message>
        <source>The alignment of %1 found no heading for it.</source>
        <translation>Die Ausrichtung vom %1 fand keine Richtung dafür.</translation>
    </message>
    <message>
        <source>Aligned %1: it looks along %L2 degrees, known to %L3 degrees.</source>
        <translation>Ausgerichtet %1: es blickt in Richtung %L2 Grad, auf %L3 Grad bekannt.</translation>
    </message>
    <message>
        <source>Aligned %1: it looks along %L2 degrees.</source>
        <translation>Ausgerichtet %1: es blickt in Richtung %L2 Grad.</translation>
    </message>
    <message>
        <source>Somebody has accepted it.</source>
        <translation>Jemand hat es angenommen.</translation>
    </message>
    <message>
        <source>Somebody has rejected it.</source>
        <translation>Jemand hat es abgelehnt.</translation>
    </message>
    <message>
        <source>Nobody has decided on it yet.</source>
        <translation>Niemand hat darüber entschieden.</translation>
    </message>
    <message>
        <source>Moved here from %1, where it was tagged first.</source>
        <translation>Von %1 hierher verlegt, wo es zuerst eingetragen war.</translation>
    </message>
    <message numerus="yes">
        <source>The station has %n other photo(s).</source>
        <translation>
            <numerusform>Der Standort hat %n anderes Foto.</numerusform>
            <numerusform>Der Standort hat %n andere Fotos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::SurveyPlanView</name>
    <message>
        <source>Nobody knows this room yet, nor where its photos stand</source>
        <translation>Diesen Raum kennt noch niemand, und auch nicht, wo seine Fotos stehen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Task</name>
    <message>
        <source>Spherewalk met a defect of its own: %1.</source>
        <translation>Spherewalk ist auf einen eigenen Fehler gestoßen: %1.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::TaskBar</name>
    <message>
        <source>&amp;Stop</source>
        <translation>Sto&amp;pp</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 anhalten</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::TaskPanel</name>
    <message>
        <source>Stop; what is complete stays</source>
        <translation>Anhalten; was fertig ist, bleibt</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>Nichts läuft.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Told</name>
    <message>
        <source>Open a survey</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Go to Plan</source>
        <translation>Zu Planen</translation>
    </message>
    <message>
        <source>Go to Capture</source>
        <translation>Zu Aufnehmen</translation>
    </message>
    <message>
        <source>Change the address</source>
        <translation>Adresse ändern</translation>
    </message>
    <message>
        <source>What the guide says</source>
        <translation>Was die Anleitung sagt</translation>
    </message>
    <message>
        <source>Change the exposure</source>
        <translation>Belichtung ändern</translation>
    </message>
    <message>
        <source>Go to Review</source>
        <translation>Zu Sichten</translation>
    </message>
    <message>
        <source>Go to Align</source>
        <translation>Zu Ausrichten</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Export with depth</source>
        <translation>Mit Tiefe exportieren</translation>
    </message>
    <message>
        <source>Look at them</source>
        <translation>Ansehen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ToleranceBox</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Pixels of the robot&apos;s camera that 95 of 100 places of a view may be displaced by</source>
        <translation>Pixel der Kamera des Roboters, um die 95 von 100 Stellen einer Ansicht verschoben sein dürfen</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Tour</name>
    <message>
        <source>This is the plan of a practice room: walls, furniture, and rails with their stops. A ring is where a rail begins. The Sheet tells how to lay the rails with a tape.</source>
        <translation>Das ist der Plan eines Übungsraums: Wände, Möbel und Schienen mit ihren Halten. Ein Ring ist der Anfang einer Schiene. Das Blatt sagt, wie man die Schienen mit dem Maßband legt.</translation>
    </message>
    <message>
        <source>The practice camera now takes the photos by itself. With a real camera, bring it to the cross on the plan and press Space.</source>
        <translation>Die Übungskamera nimmt die Fotos jetzt von selbst auf. Eine wirkliche Kamera bringen Sie zum Kreuz auf dem Plan und drücken die Leertaste.</translation>
    </message>
    <message>
        <source>Look at the photos: J and K go from one to the next, A accepts, R rejects. What the checks found is outlined in the photo. C compares with a neighbour.</source>
        <translation>Sehen Sie die Fotos durch: J und K gehen von einem zum nächsten, A nimmt an, R lehnt ab. Was die Prüfungen fanden, ist im Foto umrandet. C vergleicht mit einem Nachbarn.</translation>
    </message>
    <message>
        <source>Press Align. It solves how each photo is turned, and finds stations that were mixed up.</source>
        <translation>Drücken Sie Ausrichten. Es löst, wie jedes Foto gedreht ist, und findet verwechselte Stationen.</translation>
    </message>
    <message>
        <source>Press Preview this survey, click into the view, and drive with W A S D. That is what a robot would see. Export writes it for simulators.</source>
        <translation>Drücken Sie Dieses Projekt zeigen, klicken Sie in die Ansicht, und fahren Sie mit W A S D. Das sähe ein Roboter. Der Export schreibt es für Simulatoren.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2.&lt;/b&gt; %3</source>
        <translation>&lt;b&gt;%1 von %2.&lt;/b&gt; %3</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
</TS>
