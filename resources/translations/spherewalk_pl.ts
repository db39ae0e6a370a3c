<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl">
<context>
    <name>CameraPreset</name>
    <message>
        <source>%1, %2 x %3, %4°</source>
        <translation>%1, %2 x %3, %4°</translation>
    </message>
    <message>
        <source>Fisheye (as RealSense T265), 848 x 800</source>
        <translation>Rybie oko (jak RealSense T265), 848 x 800</translation>
    </message>
    <message>
        <source>Wide angle</source>
        <translation>Szeroki kąt</translation>
    </message>
</context>
<context>
    <name>Cure</name>
    <message>
        <source>Retag</source>
        <translation>Przenieść</translation>
    </message>
    <message>
        <source>Retake</source>
        <translation>Powtórzyć</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maska</translation>
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
        <translation>Wszystkie stanowiska</translation>
    </message>
    <message>
        <source>To be reviewed</source>
        <translation>Do oceny</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Wątpliwe</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Nieudane</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Bez zdjęcia</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Odrzucone</translation>
    </message>
    <message>
        <source>With a note</source>
        <translation>Z notatką</translation>
    </message>
    <message>
        <source>With private regions</source>
        <translation>Z obszarami prywatnymi</translation>
    </message>
</context>
<context>
    <name>Standing</name>
    <message>
        <source>missing</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>zrobione</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>przyjęte</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>wątpliwe</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nieudane</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>odrzucone</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Scans a room with a spherical camera.</source>
        <translation>Skanuje pomieszczenie kamerą sferyczną.</translation>
    </message>
    <message>
        <source>Folder of a survey to open</source>
        <translation>Folder pomiaru do otwarcia</translation>
    </message>
    <message>
        <source>Photograph the practice room with the practice camera</source>
        <translation>Sfotografuj pokój ćwiczebny kamerą ćwiczebną</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignMode</name>
    <message>
        <source>not known</source>
        <translation>nieznana</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Orientacja</translation>
    </message>
    <message>
        <source>Solve how each photo is turned, and see how well it is known</source>
        <translation>Wyznacz, jak obrócone jest każde zdjęcie, i zobacz, jak dokładnie to wiadomo</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Szkic</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Zwykła</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Staranna</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Dokładna</translation>
    </message>
    <message>
        <source>How much work goes into the pictures: about 0.1, 0.5, 1.5 or 3.5 s a photo on one core</source>
        <translation>Ile pracy idzie w zdjęcia: około 0,1, 0,5, 1,5 albo 3,5 s na zdjęcie na jednym rdzeniu</translation>
    </message>
    <message>
        <source>What the photos support</source>
        <translation>Na ile pozwalają zdjęcia</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Yaw and tilt</source>
        <translation>Obrót i pochylenie</translation>
    </message>
    <message>
        <source>And rail placements</source>
        <translation>Także położenie szyn</translation>
    </message>
    <message>
        <source>And positions</source>
        <translation>Także pozycje</translation>
    </message>
    <message>
        <source>What is solved, each with all that the ones above it solve</source>
        <translation>Co się wyznacza; każda pozycja obejmuje wszystko, co te nad nią</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Model</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far photos stand from where they are tagged, one standard deviation</source>
        <translation>Jak daleko zdjęcia stoją od miejsc, którym są przypisane; jedno odchylenie standardowe</translation>
    </message>
    <message>
        <source>&amp;Positions to</source>
        <translation>Poz&amp;ycje do</translation>
    </message>
    <message>
        <source>A picture, twice as wide as high, black where photos are not to be looked at: cart, operator</source>
        <translation>Obraz dwa razy szerszy niż wyższy, czarny tam, gdzie nie należy patrzeć na zdjęcia: wózek, operator</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Wy&amp;znacz</translation>
    </message>
    <message>
        <source>Solve how each photo is turned</source>
        <translation>Wyznacz, jak obrócone jest każde zdjęcie</translation>
    </message>
    <message>
        <source>Stop; what was found in the pictures is kept for the next run</source>
        <translation>Zatrzymaj; to, co znaleziono na zdjęciach, zostaje na następny raz</translation>
    </message>
    <message>
        <source>Photos and what the alignment says of them</source>
        <translation>Zdjęcia i co mówi o nich orientacja</translation>
    </message>
    <message>
        <source>Re&amp;tag</source>
        <translation>P&amp;rzenieś</translation>
    </message>
    <message>
        <source>Move the chosen photos to the stations that fit them</source>
        <translation>Przenieś zaznaczone zdjęcia na stanowiska, do których pasują</translation>
    </message>
    <message>
        <source>Retag a&amp;ll proposed</source>
        <translation>Przenieś wszys&amp;tkie proponowane</translation>
    </message>
    <message>
        <source>Move every photo that fits another station there</source>
        <translation>Przenieś na inne stanowisko każde zdjęcie, które tam pasuje</translation>
    </message>
    <message>
        <source>&amp;Retake</source>
        <translation>P&amp;owtórz</translation>
    </message>
    <message>
        <source>Reject the chosen photos, so that their stations are taken again</source>
        <translation>Odrzuć zaznaczone zdjęcia, aby ich stanowiska sfotografować ponownie</translation>
    </message>
    <message>
        <source>Headings of the photos</source>
        <translation>Kierunki zdjęć</translation>
    </message>
    <message>
        <source>Lines: how photos are turned. Fans: three standard deviations, %1 times as wide. Colour: standard deviation of the yaw.</source>
        <translation>Linie: jak obrócone są zdjęcia. Wachlarze: trzy odchylenia standardowe, %1 razy szersze. Kolor: odchylenie standardowe obrotu.</translation>
    </message>
    <message>
        <source>Picture that tells what is left out</source>
        <translation>Obraz, który mówi, co pominąć</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Obrazy (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>No mas&amp;k...</source>
        <translation>Bez mas&amp;ki...</translation>
    </message>
    <message>
        <source>Mas&amp;k: %1</source>
        <translation>Mas&amp;ka: %1</translation>
    </message>
    <message>
        <source>Eff&amp;ort</source>
        <translation>&amp;Jakość</translation>
    </message>
    <message>
        <source>Only photos with a fla&amp;g</source>
        <translation>Tylko zdjęcia z &amp;uwagą</translation>
    </message>
    <message>
        <source>As tagged</source>
        <translation>Jak podano</translation>
    </message>
    <message>
        <source>From the pictures alone</source>
        <translation>Z samych zdjęć</translation>
    </message>
    <message>
        <source>Where the photos were taken: as they are tagged, or solved from what they show; then the stations move there</source>
        <translation>Gdzie zrobiono zdjęcia: jak podano albo jak wynika z tego, co pokazują; wtedy stanowiska przesuną się tam</translation>
    </message>
    <message>
        <source>Pla&amp;ces</source>
        <translation>M&amp;iejsca</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Usual height of the lens above the floor: it tells how large everything is</source>
        <translation>Zwykła wysokość obiektywu nad podłogą: mówi, jak duże jest wszystko</translation>
    </message>
    <message>
        <source>Le&amp;ns at</source>
        <translation>O&amp;biektyw na</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignModel</name>
    <message>
        <source>good</source>
        <translation>dobre</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>niezorientowane</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Stanowisko</translation>
    </message>
    <message>
        <source>Where the photo was taken, in walking order</source>
        <translation>Gdzie zrobiono zdjęcie, w kolejności przejścia</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>What the alignment says of the photo</source>
        <translation>Co orientacja mówi o zdjęciu</translation>
    </message>
    <message>
        <source>Yaw °</source>
        <translation>Obrót °</translation>
    </message>
    <message>
        <source>How the photo is turned, counter-clockwise from the room&apos;s x axis</source>
        <translation>Jak obrócone jest zdjęcie, przeciwnie do ruchu wskazówek zegara od osi x pomieszczenia</translation>
    </message>
    <message>
        <source>σ yaw °</source>
        <translation>σ obrotu °</translation>
    </message>
    <message>
        <source>Standard deviation of the yaw</source>
        <translation>Odchylenie standardowe obrotu</translation>
    </message>
    <message>
        <source>σ tilt °</source>
        <translation>σ pochyl. °</translation>
    </message>
    <message>
        <source>Standard deviation of pitch or roll, the larger of them</source>
        <translation>Odchylenie standardowe pochylenia lub przechylenia, większe z nich</translation>
    </message>
    <message>
        <source>Residual °</source>
        <translation>Resztka °</translation>
    </message>
    <message>
        <source>How far the photo&apos;s matches miss, root mean square</source>
        <translation>O ile rozmijają się punkty wspólne zdjęcia, średnia kwadratowa</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pary</translation>
    </message>
    <message>
        <source>Neighbours that hold the photo</source>
        <translation>Sąsiedzi, którzy trzymają zdjęcie</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Propozycja</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Co by pomogło</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Dlaczego</translation>
    </message>
    <message>
        <source>What speaks against the photo</source>
        <translation>Co przemawia przeciw zdjęciu</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::AlignPresenter</name>
    <message numerus="yes">
        <source>Move %n photo(s) to other stations</source>
        <translation>
            <numerusform>Przeniesienie %n zdjęcia na inne stanowisko</numerusform>
            <numerusform>Przeniesienie %n zdjęć na inne stanowiska</numerusform>
            <numerusform>Przeniesienie %n zdjęć na inne stanowiska</numerusform>
        </translation>
    </message>
    <message>
        <source>The survey is not aligned yet.</source>
        <translation>Orientacja zdjęć nie jest jeszcze wyznaczona.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) came since, or were left out: align again.</source>
        <translation>
            <numerusform>%n zdjęcie doszło później albo zostało pominięte: wyznacz ponownie.</numerusform>
            <numerusform>%n zdjęcia doszły później albo zostały pominięte: wyznacz ponownie.</numerusform>
            <numerusform>%n zdjęć doszło później albo zostało pominiętych: wyznacz ponownie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Model %1.</source>
        <translation>Model %1.</translation>
    </message>
    <message>
        <source>Aligning %1</source>
        <translation>Orientacja: %1</translation>
    </message>
    <message numerus="yes">
        <source>Aligned %n photo(s) in %1.</source>
        <translation>
            <numerusform>Wyznaczono orientację %n zdjęcia w %1.</numerusform>
            <numerusform>Wyznaczono orientację %n zdjęć w %1.</numerusform>
            <numerusform>Wyznaczono orientację %n zdjęć w %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped; the survey is as it was.</source>
        <translation>Zatrzymano; pomiar jest taki, jaki był.</translation>
    </message>
    <message>
        <source>Another job is changing the survey; try again when it has ended.</source>
        <translation>Inne zadanie zmienia pomiar; spróbuj ponownie, gdy się zakończy.</translation>
    </message>
    <message>
        <source>Moving photos to other stations</source>
        <translation>Przenoszenie zdjęć na inne stanowiska</translation>
    </message>
    <message numerus="yes">
        <source>Moved %n photo(s); align again to be sure.</source>
        <translation>
            <numerusform>Przeniesiono %n zdjęcie; dla pewności wyznacz orientację ponownie.</numerusform>
            <numerusform>Przeniesiono %n zdjęcia; dla pewności wyznacz orientację ponownie.</numerusform>
            <numerusform>Przeniesiono %n zdjęć; dla pewności wyznacz orientację ponownie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Alignment of %n photo(s): %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>Orientacja %n zdjęcia: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
            <numerusform>Orientacja %n zdjęć: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
            <numerusform>Orientacja %n zdjęć: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With what the checks found, %n photo(s) are to be looked at in Review.</source>
        <translation>
            <numerusform>Razem z wynikami kontroli %n zdjęcie trzeba obejrzeć w Ocenie.</numerusform>
            <numerusform>Razem z wynikami kontroli %n zdjęcia trzeba obejrzeć w Ocenie.</numerusform>
            <numerusform>Razem z wynikami kontroli %n zdjęć trzeba obejrzeć w Ocenie.</numerusform>
        </translation>
    </message>
    <message>
        <source>Moved to this station since; align again.</source>
        <translation>Przeniesiono od tego czasu na to stanowisko; wyznacz ponownie.</translation>
    </message>
    <message>
        <source>There is no photo to align yet; capture or import some first.</source>
        <translation>Nie ma jeszcze czego orientować; najpierw zrób lub zaimportuj zdjęcia.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Application</name>
    <message>
        <source>Spherewalk met a defect of its own: %1.</source>
        <translation>Spherewalk natrafił na własny błąd: %1.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraBox</name>
    <message>
        <source>From a ROS file...</source>
        <translation>Z pliku ROS...</translation>
    </message>
    <message>
        <source>Camera model</source>
        <translation>Model kamery</translation>
    </message>
    <message>
        <source>The robot&apos;s camera; a ROS camera-info YAML has your own one&apos;s calibration</source>
        <translation>Kamera robota; w pliku YAML camera-info z ROS jest kalibracja Twojej własnej</translation>
    </message>
    <message>
        <source>ROS camera-info file</source>
        <translation>Plik camera-info z ROS</translation>
    </message>
    <message>
        <source>Camera info (*.yaml *.yml)</source>
        <translation>Camera info (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraFinder</name>
    <message>
        <source>Looking for cameras...</source>
        <translation>Szukanie kamer...</translation>
    </message>
    <message>
        <source>Looking for cameras</source>
        <translation>Szukanie kamer</translation>
    </message>
    <message>
        <source>No camera answers. Switch it on, connect this computer to its WiFi, and look again.</source>
        <translation>Żadna kamera nie odpowiada. Włącz ją, połącz ten komputer z jej siecią WiFi i poszukaj ponownie.</translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s) found</source>
        <translation>
            <numerusform>Znaleziono %n kamerę</numerusform>
            <numerusform>Znaleziono %n kamery</numerusform>
            <numerusform>Znaleziono %n kamer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraLogin</name>
    <message>
        <source>The system&apos;s keychain did not keep the password (%1); it is asked for again when the program starts next.</source>
        <translation>Systemowy pęk kluczy nie zachował hasła (%1); program zapyta o nie przy następnym uruchomieniu.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraPanel</name>
    <message>
        <source>&amp;Connect</source>
        <translation>P&amp;ołącz</translation>
    </message>
    <message>
        <source>&amp;Practice camera</source>
        <translation>&amp;Kamera ćwiczebna</translation>
    </message>
    <message>
        <source>Shoot by &amp;itself</source>
        <translation>Fotografuj samoczynn&amp;ie</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>Adres kamery</translation>
    </message>
    <message>
        <source>Address of the camera, with :port if it is not 80.</source>
        <translation>Adres kamery, z :port, jeśli nie jest to 80.</translation>
    </message>
    <message>
        <source>Ask the camera at this address how it is.</source>
        <translation>Zapytaj kamerę pod tym adresem o jej stan.</translation>
    </message>
    <message>
        <source>Time to hide</source>
        <translation>Czas na ukrycie się</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>From the key to the shot, so that nobody is in the picture.</source>
        <translation>Od klawisza do zdjęcia, aby nikogo nie było w kadrze.</translation>
    </message>
    <message>
        <source>The practice camera moves from station to station without the key.</source>
        <translation>Kamera ćwiczebna przechodzi od stanowiska do stanowiska bez klawisza.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Bateria</translation>
    </message>
    <message>
        <source>Storage of the camera</source>
        <translation>Pamięć kamery</translation>
    </message>
    <message>
        <source>Temperature of the camera</source>
        <translation>Temperatura kamery</translation>
    </message>
    <message>
        <source>connecting...</source>
        <translation>łączenie...</translation>
    </message>
    <message>
        <source>no camera</source>
        <translation>brak kamery</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>(charging)</source>
        <translation>(ładuje się)</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s)</source>
        <translation>
            <numerusform>%n zdjęcie</numerusform>
            <numerusform>%n zdjęcia</numerusform>
            <numerusform>%n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>za gorąca</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>ciepła</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>w normie</translation>
    </message>
    <message>
        <source>Looks where cameras usually are, and for those that announce themselves on the network.</source>
        <translation>Szuka tam, gdzie kamery zwykle są, oraz tych, które ogłaszają się w sieci.</translation>
    </message>
    <message>
        <source>Cameras that were found</source>
        <translation>Znalezione kamery</translation>
    </message>
    <message>
        <source>Choose the camera to connect to.</source>
        <translation>Wybierz kamerę do połączenia.</translation>
    </message>
    <message>
        <source>How the camera is set for the photos of this survey.</source>
        <translation>Jak ustawiona jest kamera dla zdjęć tego pomiaru.</translation>
    </message>
    <message>
        <source>&amp;Live preview</source>
        <translation>Pod&amp;gląd na żywo</translation>
    </message>
    <message>
        <source>What the camera sees, until the picture is taken.</source>
        <translation>Co widzi kamera, do chwili zrobienia zdjęcia.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wybierz...</translation>
    </message>
    <message>
        <source>Fi&amp;nd cameras</source>
        <translation>Z&amp;najdź kamery</translation>
    </message>
    <message>
        <source>E&amp;xposure: %1</source>
        <translation>Ek&amp;spozycja: %1</translation>
    </message>
    <message>
        <source>The camera inside of the program, which photographs a practice room.</source>
        <translation>Kamera wewnątrz programu, która fotografuje pokój ćwiczebny.</translation>
    </message>
    <message>
        <source>Ti&amp;me to hide:</source>
        <translation>Czas na &amp;ukrycie:</translation>
    </message>
    <message>
        <source>Practice camera</source>
        <translation>Kamera ćwiczebna</translation>
    </message>
    <message>
        <source>The practice camera photographs a room of the program. Its photos would become photos of %1.</source>
        <translation>Kamera ćwiczebna fotografuje pokój z programu. Jego zdjęcia stałyby się zdjęciami pomiaru %1.</translation>
    </message>
    <message>
        <source>&amp;Use it here</source>
        <translation>&amp;Użyj go tutaj</translation>
    </message>
    <message>
        <source>Leave the &amp;practice camera</source>
        <translation>Odłącz &amp;kamerę ćwiczebną</translation>
    </message>
    <message>
        <source>practice camera</source>
        <translation>kamera ćwiczebna</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>brak odpowiedzi</translation>
    </message>
    <message>
        <source>A phone or tablet on the cart shows the next station, shoots, and shows the last photo.</source>
        <translation>Telefon lub tablet na wózku pokazuje następne stanowisko, wyzwala zdjęcie i pokazuje ostatnie zdjęcie.</translation>
    </message>
    <message>
        <source>Phone as remote: on...</source>
        <translation>Pilot: włączony...</translation>
    </message>
    <message>
        <source>Phone as remote...</source>
        <translation>Telefon jako pilot...</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureDesk</name>
    <message>
        <source>Connecting to %1</source>
        <translation>Łączenie z %1</translation>
    </message>
    <message>
        <source>Starting the practice camera</source>
        <translation>Uruchamianie kamery ćwiczebnej</translation>
    </message>
    <message>
        <source>Capturing %1</source>
        <translation>Fotografowanie: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureMode</name>
    <message>
        <source>Every station has its photo.</source>
        <translation>Każde stanowisko ma swoje zdjęcie.</translation>
    </message>
    <message>
        <source>Capturing has ended; it goes on where it stopped.</source>
        <translation>Fotografowanie zakończone; ruszy od miejsca, w którym stanęło.</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <source>Space, Return, Page Down, or a presenter&apos;s button.</source>
        <translation>Spacja, Enter, Page Down albo przycisk prezentera.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Zatrzymaj</translation>
    </message>
    <message>
        <source>Ends after what is stored already; capturing goes on from there later (Escape).</source>
        <translation>Kończy na tym, co już zapisane; potem można ruszyć od tego miejsca (Escape).</translation>
    </message>
    <message>
        <source>photos left</source>
        <translation>zdjęć zostało</translation>
    </message>
    <message>
        <source>time left</source>
        <translation>czasu zostało</translation>
    </message>
    <message>
        <source>photos a minute</source>
        <translation>zdjęć na minutę</translation>
    </message>
    <message>
        <source>To be taken again</source>
        <translation>Do powtórzenia</translation>
    </message>
    <message>
        <source>Puts the station that is selected on the plan on the list, or takes it off.</source>
        <translation>Dodaje stanowisko zaznaczone na planie do listy albo je z niej usuwa.</translation>
    </message>
    <message>
        <source>Do not take it again</source>
        <translation>Nie powtarzaj</translation>
    </message>
    <message>
        <source>Take the selected station again</source>
        <translation>Powtórz zaznaczone stanowisko</translation>
    </message>
    <message>
        <source>Take the photos, station by station</source>
        <translation>Rób zdjęcia, stanowisko po stanowisku</translation>
    </message>
    <message>
        <source>Align (A)</source>
        <translation>Orientacja (A)</translation>
    </message>
    <message>
        <source>%1 taken, %2 doubtful, %3 failed</source>
        <translation>%1 zrobionych, %2 wątpliwych, %3 nieudanych</translation>
    </message>
    <message numerus="yes">
        <source>Look at %n in Review (R)</source>
        <translation>
            <numerusform>Obejrzyj %n w Ocenie (R)</numerusform>
            <numerusform>Obejrzyj %n w Ocenie (R)</numerusform>
            <numerusform>Obejrzyj %n w Ocenie (R)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Take %n again (T)</source>
        <translation>
            <numerusform>Zrób %n ponownie (T)</numerusform>
            <numerusform>Zrób %n ponownie (T)</numerusform>
            <numerusform>Zrób %n ponownie (T)</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at the doubtful photos while the rail is still here.</source>
        <translation>Obejrzyj wątpliwe zdjęcia, póki szyna jest jeszcze na miejscu.</translation>
    </message>
    <message>
        <source>Next: solve how each photo is turned.</source>
        <translation>Dalej: oblicz, jak obrócone jest każde zdjęcie.</translation>
    </message>
    <message>
        <source>Space, Return, Page Down</source>
        <translation>Spacja, Enter, Page Down</translation>
    </message>
    <message>
        <source>Start, shoot, try again, or end the countdown</source>
        <translation>Zacznij, zrób zdjęcie, spróbuj ponownie albo przerwij odliczanie</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Stop capturing</source>
        <translation>Zatrzymaj fotografowanie</translation>
    </message>
    <message>
        <source>At the end: review, take again, align</source>
        <translation>Na końcu: oceń, zrób ponownie, orientacja</translation>
    </message>
    <message>
        <source>PRACTICE. %1</source>
        <translation>ĆWICZENIE. %1</translation>
    </message>
    <message>
        <source>The walk has ended; another one goes on from here.</source>
        <translation>Obchód zakończony; następny zacznie się od tego miejsca.</translation>
    </message>
    <message>
        <source>photos taken</source>
        <translation>zrobionych zdjęć</translation>
    </message>
    <message>
        <source>of known place</source>
        <translation>o znanym miejscu</translation>
    </message>
    <message>
        <source>Go on, or solve where the photos were taken.</source>
        <translation>Fotografuj dalej albo oblicz, gdzie zrobiono zdjęcia.</translation>
    </message>
    <message>
        <source>Go on where photos are missing.</source>
        <translation>Fotografuj dalej tam, gdzie brakuje zdjęć.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CapturePlanView</name>
    <message>
        <source>to be taken again</source>
        <translation>do powtórzenia</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CaptureWords</name>
    <message>
        <source>Every station has its photo.</source>
        <translation>Każde stanowisko ma swoje zdjęcie.</translation>
    </message>
    <message>
        <source>Connect a camera, or try the practice camera.</source>
        <translation>Połącz kamerę albo wypróbuj kamerę ćwiczebną.</translation>
    </message>
    <message>
        <source>Connecting...</source>
        <translation>Łączenie...</translation>
    </message>
    <message>
        <source>The next station:</source>
        <translation>Następne stanowisko:</translation>
    </message>
    <message>
        <source>Preparing the camera...</source>
        <translation>Przygotowywanie kamery...</translation>
    </message>
    <message>
        <source>Bring the camera to</source>
        <translation>Ustaw kamerę na</translation>
    </message>
    <message>
        <source>No picture was taken at</source>
        <translation>Nie wykonano zdjęcia na</translation>
    </message>
    <message>
        <source>Hide! The picture is taken at</source>
        <translation>Ukryj się! Zdjęcie na</translation>
    </message>
    <message>
        <source>Taking the picture at</source>
        <translation>Wykonywanie zdjęcia na</translation>
    </message>
    <message>
        <source>Shoot</source>
        <translation>Zdjęcie</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>%1 ... (press to wait)</source>
        <translation>%1 ... (naciśnij, by poczekać)</translation>
    </message>
    <message>
        <source>Please wait</source>
        <translation>Proszę czekać</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>The photo is stored.</source>
        <translation>Zdjęcie zapisane.</translation>
    </message>
    <message>
        <source>PRACTICE: photos of a room that exists only in the program</source>
        <translation>ĆWICZENIE: zdjęcia pokoju, który istnieje tylko w programie</translation>
    </message>
    <message>
        <source>By hand: walk through the room and shoot.</source>
        <translation>Z ręki: przejdź przez pomieszczenie i rób zdjęcia.</translation>
    </message>
    <message>
        <source>Stand where you like and shoot</source>
        <translation>Stań, gdzie chcesz, i zrób zdjęcie</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ColumnScrollArea</name>
    <message>
        <source>Column that scrolls</source>
        <translation>Przewijana kolumna</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CoreWords</name>
    <message>
        <source>It is %1 pixels wide instead of %2; set the camera&apos;s size and take it again.</source>
        <translation>Ma %1 pikseli szerokości zamiast %2; ustaw rozmiar w aparacie i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It says that it is no whole stitched sphere; switch stitching on in the camera and take it again.</source>
        <translation>Zdjęcie mówi, że nie jest całą złożoną sferą; włącz składanie w aparacie i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It says that the camera hung upside down; put it upright and take it again.</source>
        <translation>Zdjęcie mówi, że kamera wisiała do góry nogami; ustaw ją prosto i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera leaned by %1 degrees; check its mount.</source>
        <translation>Kamera była pochylona o %1 stopni; sprawdź jej mocowanie.</translation>
    </message>
    <message>
        <source>It was exposed for %1 s instead of %2 s; take it again.</source>
        <translation>Naświetlano je %1 s zamiast %2 s; zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It was taken at ISO %1 instead of %2; take it again.</source>
        <translation>Zrobiono je z ISO %1 zamiast %2; zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It was taken with a fixed white balance, against the survey&apos;s settings; take it again if its colours differ.</source>
        <translation>Zrobiono je ze stałym balansem bieli, wbrew ustawieniom pomiaru; zrób je jeszcze raz, jeśli jego kolory się różnią.</translation>
    </message>
    <message>
        <source>It was taken with automatic white balance, against the survey&apos;s settings; take it again if its colours differ.</source>
        <translation>Zrobiono je z automatycznym balansem bieli, wbrew ustawieniom pomiaru; zrób je jeszcze raz, jeśli jego kolory się różnią.</translation>
    </message>
    <message>
        <source>It is too dark; check the lens and the exposure.</source>
        <translation>Jest za ciemne; sprawdź obiektyw i ekspozycję.</translation>
    </message>
    <message>
        <source>It is too bright; check the exposure.</source>
        <translation>Jest za jasne; sprawdź ekspozycję.</translation>
    </message>
    <message>
        <source>It is %1 stops darker than its neighbours; check the exposure and the lamps.</source>
        <translation>Jest o %1 EV ciemniejsze od sąsiadów; sprawdź ekspozycję i lampy.</translation>
    </message>
    <message>
        <source>It is %1 stops brighter than its neighbours; check the exposure and the lamps.</source>
        <translation>Jest o %1 EV jaśniejsze od sąsiadów; sprawdź ekspozycję i lampy.</translation>
    </message>
    <message>
        <source>It is %1 stops darker than %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Jest o %1 EV ciemniejsze niż %2, a zbyt mało zdjęć wskazuje, które z nich jest złe; obejrzyj oba i powtórz złe.</translation>
    </message>
    <message>
        <source>It is %1 stops brighter than %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Jest o %1 EV jaśniejsze niż %2, a zbyt mało zdjęć wskazuje, które z nich jest złe; obejrzyj oba i powtórz złe.</translation>
    </message>
    <message>
        <source>Its colours differ by %1 % from those of %2, and too few photos tell which of the two is wrong; look at both, and take the wrong one again.</source>
        <translation>Jego kolory różnią się o %1 % od kolorów %2, a zbyt mało zdjęć wskazuje, które z nich jest złe; obejrzyj oba i powtórz złe.</translation>
    </message>
    <message>
        <source>Its colours differ by %1 % from its neighbours&apos;; fix the white balance, and check the lamps.</source>
        <translation>Jego kolory różnią się o %1 % od kolorów sąsiadów; ustal balans bieli i sprawdź lampy.</translation>
    </message>
    <message>
        <source>%1 % of it is black; check that nothing covers a lens.</source>
        <translation>%1 % zdjęcia jest czarne; sprawdź, czy nic nie zasłania obiektywu.</translation>
    </message>
    <message>
        <source>%1 % of it is burnt out; shorten the exposure, or keep the light out.</source>
        <translation>%1 % zdjęcia jest prześwietlone; skróć ekspozycję albo odetnij światło.</translation>
    </message>
    <message>
        <source>Something is in view that its neighbours do not show, %1 degrees to the left of the picture&apos;s middle (%2 % of the sphere); if it is a person, step aside and take it again.</source>
        <translation>Widać coś, czego sąsiedzi nie pokazują, %1 stopni na lewo od środka zdjęcia (%2 % sfery); jeśli to człowiek, odejdź na bok i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>Something is in view that its neighbours do not show, %1 degrees to the right of the picture&apos;s middle (%2 % of the sphere); if it is a person, step aside and take it again.</source>
        <translation>Widać coś, czego sąsiedzi nie pokazują, %1 stopni na prawo od środka zdjęcia (%2 % sfery); jeśli to człowiek, odejdź na bok i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera was turned by %1 degrees against its neighbours, which all look one way; check its mount.</source>
        <translation>Kamera była obrócona o %1 stopni względem sąsiadów, które patrzą w jedną stronę; sprawdź jej mocowanie.</translation>
    </message>
    <message>
        <source>It is blurred: its edges are %1 times as wide as they should be; let the camera come to rest and take it again.</source>
        <translation>Jest nieostre: jego krawędzie są %1 razy szersze, niż powinny; pozwól kamerze się uspokoić i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It is upside down against its neighbours; put the camera upright and take it again.</source>
        <translation>Jest do góry nogami względem sąsiadów; ustaw kamerę prosto i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>It does not look like its neighbours, however it is turned; check that the camera stood at this station.</source>
        <translation>Nie jest podobne do sąsiadów, jakkolwiek je obrócić; sprawdź, czy kamera stała na tym stanowisku.</translation>
    </message>
    <message>
        <source>It shows the same as %1, from the same place: the camera was not moved in between; retake the one whose station is wrong.</source>
        <translation>Pokazuje to samo co %1, z tego samego miejsca: kamery w międzyczasie nie przesunięto; powtórz to, którego stanowisko się nie zgadza.</translation>
    </message>
    <message>
        <source>It seems to stand %1 cm from where it is tagged, farther off than the others: correct its position, or retake it at its station.</source>
        <translation>Zdaje się stać %1 cm od podanego miejsca, dalej niż inne: popraw jego pozycję albo zrób je jeszcze raz na jego stanowisku.</translation>
    </message>
    <message>
        <source>Its rotation against its neighbours is known to %1 deg only: it shares too little with them; retake it with more light, or with more to see.</source>
        <translation>Jego obrót względem sąsiadów jest znany tylko do %1 stopnia: ma z nimi za mało wspólnego; zrób je jeszcze raz przy lepszym świetle albo tam, gdzie więcej widać.</translation>
    </message>
    <message>
        <source>The model yaw does not solve its tilt, so its rotation against its neighbours is known to %1 deg only: take more photos near it.</source>
        <translation>Model yaw nie oblicza jego pochylenia, więc jego obrót względem sąsiadów jest znany tylko do %1 stopnia: zrób więcej zdjęć w jego pobliżu.</translation>
    </message>
    <message>
        <source>Its neighbours contradict %1 % of what it shows; look at the picture, and retake it if it is not of this place.</source>
        <translation>Sąsiedzi zaprzeczają %1 % tego, co pokazuje; obejrzyj zdjęcie i zrób je jeszcze raz, jeśli nie jest z tego miejsca.</translation>
    </message>
    <message>
        <source>It belongs to a part of the survey that nothing connects with the rest (%1 parts): headings are right within the part, and the part&apos;s own rests on its positions alone; take photos between the parts.</source>
        <translation>Należy do części pomiaru, której nic nie łączy z resztą (części: %1): kierunki zgadzają się wewnątrz części, a kierunek samej części wynika tylko z jej pozycji; zrób zdjęcia między częściami.</translation>
    </message>
    <message>
        <source>Where it was taken is known to %1 cm only: correct its position, or retake it at its station.</source>
        <translation>Miejsce zrobienia jest znane tylko do %1 cm: popraw jego pozycję albo zrób je jeszcze raz na jego stanowisku.</translation>
    </message>
    <message>
        <source>It was taken at one place with %1, though their tags lie %2 m apart: the camera was not moved between them.</source>
        <translation>Zrobiono je w tym samym miejscu co %1, choć podane miejsca są odległe o %2 m: kamery między nimi nie przesunięto.</translation>
    </message>
    <message>
        <source>Retake the one whose tag is wrong.</source>
        <translation>Zrób jeszcze raz to, którego miejsce jest podane źle.</translation>
    </message>
    <message>
        <source>There was nothing to solve.</source>
        <translation>Nie było nic do wyznaczenia.</translation>
    </message>
    <message>
        <source>It was asked for.</source>
        <translation>O to poproszono.</translation>
    </message>
    <message>
        <source>Photos with wrong tags are solved with their places.</source>
        <translation>Zdjęcia ze złym miejscem są wyznaczane razem z miejscem.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; is the richest, and every step to it helped: matches that were held out miss by %2.</source>
        <translation>Model &apos;%1&apos; jest najbogatszy i każdy krok do niego pomógł: odłożone dopasowania chybiają o %2.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; is the richest whose gain exceeds its noise: matches that were held out miss by %2.</source>
        <translation>Model &apos;%1&apos; jest najbogatszym, którego zysk przewyższa szum: odłożone dopasowania chybiają o %2.</translation>
    </message>
    <message>
        <source>There is something by the name %1 already; choose another name, or remove it.</source>
        <translation>Jest już coś o nazwie %1; wybierz inną nazwę albo to usuń.</translation>
    </message>
    <message>
        <source>1 station has no photo: near them, views come from farther away.</source>
        <translation>1 stanowisko nie ma zdjęcia: w jego pobliżu widoki pochodzą z większej odległości.</translation>
    </message>
    <message>
        <source>%1 stations have no photo: near them, views come from farther away.</source>
        <translation>Stanowiska bez zdjęcia: %1; w ich pobliżu widoki pochodzą z większej odległości.</translation>
    </message>
    <message>
        <source>1 photo was rejected and is left out.</source>
        <translation>1 zdjęcie odrzucono i jest pominięte.</translation>
    </message>
    <message>
        <source>%1 photos were rejected and are left out.</source>
        <translation>Odrzucone i pominięte zdjęcia: %1.</translation>
    </message>
    <message>
        <source>%1 photos have no known heading: they would be exported as if they looked along the room&apos;s x axis; align again, or reject them.</source>
        <translation>Zdjęcia bez znanego kierunku: %1; byłyby wyeksportowane tak, jakby patrzyły wzdłuż osi x pokoju; wyznacz ponownie albo je odrzuć.</translation>
    </message>
    <message>
        <source>The alignment of %1 photos is doubtful; review them, or export them as they are.</source>
        <translation>Wyznaczenie %1 zdjęć jest wątpliwe; oceń je albo wyeksportuj, jak są.</translation>
    </message>
    <message>
        <source>The alignment of 1 photo is doubtful; review it, or export it as it is.</source>
        <translation>Wyznaczenie 1 zdjęcia jest wątpliwe; oceń je albo wyeksportuj, jak jest.</translation>
    </message>
    <message>
        <source>The cheapest that holds %1 px is the scene model %2 with sampling %3: 95 of 100 places are displaced by at most %4 px, in %5 ms a view.</source>
        <translation>Najtańszy, który utrzymuje %1 px, to model sceny %2 z próbkowaniem %3: 95 ze 100 miejsc jest przesuniętych najwyżej o %4 px, w %5 ms na widok.</translation>
    </message>
    <message>
        <source>No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model %2 with sampling %3, reaches %4 px.</source>
        <translation>Żadna możliwość tego zbioru danych nie utrzymuje %1 px w 95 ze 100 miejsc; najlepsza, model sceny %2 z próbkowaniem %3, osiąga %4 px.</translation>
    </message>
    <message>
        <source>Take photos closer together.</source>
        <translation>Rób zdjęcia gęściej.</translation>
    </message>
    <message>
        <source>No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model %2 with sampling %3, misses more than 5 of 100 places.</source>
        <translation>Żadna możliwość tego zbioru danych nie utrzymuje %1 px w 95 ze 100 miejsc; najlepsza, model sceny %2 z próbkowaniem %3, chybia w więcej niż 5 ze 100 miejsc.</translation>
    </message>
    <message>
        <source>Take photos closer together, or export the dataset with a richer scene model.</source>
        <translation>Rób zdjęcia gęściej albo wyeksportuj zbiór danych z bogatszym modelem sceny.</translation>
    </message>
    <message>
        <source>Could not reach the camera at %1 within %2; press its power button in case it sleeps, and check that this computer is on the camera&apos;s WiFi.</source>
        <translation>Nie udało się połączyć z kamerą pod %1 w ciągu %2; naciśnij jej włącznik, jeśli śpi, i sprawdź, czy ten komputer jest w jej sieci WiFi.</translation>
    </message>
    <message>
        <source>No answer from the camera at %1 within %2; press its power button in case it sleeps, and check the WiFi.</source>
        <translation>Kamera pod %1 nie odpowiedziała w ciągu %2; naciśnij jej włącznik, jeśli śpi, i sprawdź WiFi.</translation>
    </message>
    <message>
        <source>Could not reach the camera at %1 (%2); check that it is switched on, that no USB data cable is plugged in, and that this computer is on its WiFi.</source>
        <translation>Nie udało się połączyć z kamerą pod %1 (%2); sprawdź, czy jest włączona, czy nie jest podłączony kabel USB i czy ten komputer jest w jej sieci WiFi.</translation>
    </message>
    <message>
        <source>The connection to the camera at %1 broke (%2); move closer to the camera, check the WiFi, and try again.</source>
        <translation>Połączenie z kamerą pod %1 zostało przerwane (%2); podejdź bliżej kamery, sprawdź WiFi i spróbuj jeszcze raz.</translation>
    </message>
    <message>
        <source>What answers at %1 does not speak HTTP; check the address of the camera.</source>
        <translation>To, co odpowiada pod %1, nie mówi po HTTP; sprawdź adres kamery.</translation>
    </message>
    <message>
        <source>What answers at %1 sent more than a camera would; check the address.</source>
        <translation>To, co odpowiada pod %1, przysłało więcej, niż przysłałaby kamera; sprawdź adres.</translation>
    </message>
    <message>
        <source>What answers at http://%1 is not a spherical camera (%2); check that this computer is on the camera&apos;s WiFi and not also on another network with the same addresses, and check the address.</source>
        <translation>To, co odpowiada pod http://%1, nie jest kamerą sferyczną (%2); sprawdź adres oraz czy ten komputer jest w sieci WiFi kamery, a nie w innej sieci o tych samych adresach.</translation>
    </message>
    <message>
        <source>The download from the camera at %1 stood still for %2; move closer to the camera and try again.</source>
        <translation>Pobieranie z kamery pod %1 stało przez %2; podejdź bliżej kamery i spróbuj jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera&apos;s address &quot;%1&quot; cannot be used; write it like 192.168.1.1 or http://127.0.0.1:8080.</source>
        <translation>Adresu kamery &quot;%1&quot; nie można użyć; wpisz na przykład 192.168.1.1 lub http://127.0.0.1:8080.</translation>
    </message>
    <message>
        <source>The camera named a photo by &quot;%1&quot;, which is not a usable URL; update its firmware.</source>
        <translation>Kamera nazwała zdjęcie &quot;%1&quot;, co nie jest poprawnym adresem URL; zaktualizuj jej oprogramowanie.</translation>
    </message>
    <message>
        <source>The camera names photos as API level 1 does (&quot;%1&quot;); such cameras cannot be used yet.</source>
        <translation>Kamera nazywa zdjęcia jak API poziomu 1 (&quot;%1&quot;); takich kamer jeszcze nie można używać.</translation>
    </message>
    <message>
        <source>The camera at %1 sent %2; switch it off and on if this persists.</source>
        <translation>Kamera pod %1 przysłała %2; wyłącz ją i włącz, jeśli to się powtarza.</translation>
    </message>
    <message>
        <source>an empty answer</source>
        <translation>pustą odpowiedź</translation>
    </message>
    <message>
        <source>an answer that is not valid JSON</source>
        <translation>odpowiedź, która nie jest poprawnym JSON-em</translation>
    </message>
    <message>
        <source>The camera at %1 sent JSON that is not an object; update its firmware.</source>
        <translation>Kamera pod %1 przysłała JSON, który nie jest obiektem; zaktualizuj jej oprogramowanie.</translation>
    </message>
    <message>
        <source>The camera at %1 has sent no picture of its preview for %2 s; check the WiFi, press the camera&apos;s button in case it sleeps, and start the preview again.</source>
        <translation>Kamera pod %1 od %2 s nie przysłała obrazu podglądu; sprawdź WiFi, naciśnij przycisk kamery, jeśli śpi, i włącz podgląd jeszcze raz.</translation>
    </message>
    <message>
        <source>A plug-in runs on the camera; end it by the camera&apos;s mode button, then resume.</source>
        <translation>W kamerze działa wtyczka; zakończ ją przyciskiem trybu kamery i kontynuuj.</translation>
    </message>
    <message>
        <source>The camera&apos;s battery is at %1; charge it before going on.</source>
        <translation>Bateria kamery ma %1; naładuj ją, zanim będziesz kontynuować.</translation>
    </message>
    <message>
        <source>The camera&apos;s battery is at %1; charge it soon.</source>
        <translation>Bateria kamery ma %1; naładuj ją wkrótce.</translation>
    </message>
    <message>
        <source>The camera has room for only %1 more photos.</source>
        <translation>W aparacie jest miejsce jeszcze tylko na %1 zdjęć.</translation>
    </message>
    <message>
        <source>The camera&apos;s storage is full; back its photos up, free some space, and resume.</source>
        <translation>Pamięć kamery jest pełna; skopiuj jej zdjęcia, zwolnij miejsce i kontynuuj.</translation>
    </message>
    <message>
        <source>Another camera answers (serial number %1 instead of %2); check the WiFi, or connect anew.</source>
        <translation>Odpowiada inna kamera (numer seryjny %1 zamiast %2); sprawdź WiFi albo połącz się od nowa.</translation>
    </message>
    <message>
        <source>Another camera answers now (serial number %1); whether the camera %2 has taken this photo must be looked up on it.</source>
        <translation>Odpowiada teraz inna kamera (numer seryjny %1); czy kamera %2 zrobiła to zdjęcie, trzeba sprawdzić w niej.</translation>
    </message>
    <message>
        <source>The camera %1 speaks neither API level 1 nor 2; use another.</source>
        <translation>Kamera %1 nie zna API poziomu 1 ani 2; użyj innej.</translation>
    </message>
    <message>
        <source>The photo %1 has %2 x %3 pixels, but a spherical photo is twice as wide as high and at least %4 wide; set the camera to full-size stitched photos.</source>
        <translation>Zdjęcie %1 ma %2 x %3 pikseli, a zdjęcie sferyczne jest dwa razy szersze niż wyższe i ma co najmniej %4 szerokości; ustaw kamerę na złożone zdjęcia w pełnym rozmiarze.</translation>
    </message>
    <message>
        <source>The camera has given the name %1 to another photo, so that this one is gone; take it again.</source>
        <translation>Kamera nadała nazwę %1 innemu zdjęciu, więc tego już nie ma; zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>The photo %1 is not a JPEG; set the camera to JPEG and take it again.</source>
        <translation>Zdjęcie %1 nie jest plikiem JPEG; ustaw kamerę na JPEG i zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera stays busy (&quot;%1&quot;); end what it is doing, or switch it off and on, then resume.</source>
        <translation>Kamera jest wciąż zajęta (&quot;%1&quot;); zakończ to, co robi, albo wyłącz ją i włącz, i kontynuuj.</translation>
    </message>
    <message>
        <source>The camera says that it is still taking the photo long after it must have been done; switch it off and on, then resume.</source>
        <translation>Kamera twierdzi, że wciąż robi zdjęcie, choć dawno powinna skończyć; wyłącz ją i włącz, i kontynuuj.</translation>
    </message>
    <message>
        <source>The camera stays busy or gives no steady answer about its files; switch it off and on, then resume.</source>
        <translation>Kamera jest wciąż zajęta lub niespójnie odpowiada o swoich plikach; wyłącz ją i włącz, i kontynuuj.</translation>
    </message>
    <message>
        <source>The camera has taken no photo; it can be taken again.</source>
        <translation>Kamera nie zrobiła zdjęcia; można je zrobić jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera says that it has taken the photo, but has no new file: its files were deleted, or their names begin anew.</source>
        <translation>Kamera twierdzi, że zrobiła zdjęcie, ale nie ma nowego pliku: jej pliki usunięto albo ich nazwy zaczynają się od nowa.</translation>
    </message>
    <message>
        <source>The camera started a session without a name; switch it off and on.</source>
        <translation>Kamera rozpoczęła sesję bez nazwy; wyłącz ją i włącz.</translation>
    </message>
    <message>
        <source>The camera stays at API level 1 although it offers level 2; switch it off and on.</source>
        <translation>Kamera pozostaje przy API poziomu 1, choć oferuje poziom 2; wyłącz ją i włącz.</translation>
    </message>
    <message>
        <source>The camera takes no photos %1 pixels wide, but %2.</source>
        <translation>Kamera nie robi zdjęć o szerokości %1 pikseli, lecz %2.</translation>
    </message>
    <message>
        <source>Change the survey&apos;s capture profile.</source>
        <translation>Zmień ustawienia zdjęć pomiaru.</translation>
    </message>
    <message>
        <source>The camera does not offer the white balance %1.</source>
        <translation>Kamera nie ma balansu bieli %1.</translation>
    </message>
    <message>
        <source>The camera does not offer the %1 %2; the nearest are %3.</source>
        <translation>Kamera nie oferuje wartości %1 %2; najbliższe to %3.</translation>
    </message>
    <message>
        <source>The camera stays in the mode &quot;%1&quot;; set it to still pictures by its mode button.</source>
        <translation>Kamera pozostaje w trybie &quot;%1&quot;; przyciskiem trybu ustaw robienie zdjęć.</translation>
    </message>
    <message>
        <source>The camera does not take spherical JPEGs twice as wide as high; set it to stitched JPEG photos.</source>
        <translation>Kamera nie robi sferycznych JPEG-ów dwa razy szerszych niż wyższych; ustaw złożone zdjęcia JPEG.</translation>
    </message>
    <message>
        <source>The camera could not be told that it may sleep again; switch it off and on if it is not used soon.</source>
        <translation>Nie udało się powiedzieć kamerze, że może znów zasypiać; wyłącz ją i włącz, jeśli nie będzie wkrótce używana.</translation>
    </message>
    <message>
        <source>The downloaded photo changed on the disk before it was recorded; the next run downloads it again.</source>
        <translation>Pobrane zdjęcie zmieniło się na dysku, zanim je zapisano; następny przebieg pobierze je jeszcze raz.</translation>
    </message>
    <message>
        <source>The photo of %1 is not known to be its own any more; take it again.</source>
        <translation>Nie wiadomo już, czy zdjęcie %1 jest jego własnym; zrób je jeszcze raz.</translation>
    </message>
    <message>
        <source>The camera refused to %1: %2.</source>
        <translation>Kamera odmówiła (%1): %2.</translation>
    </message>
    <message>
        <source>this camera cannot do it; update its firmware or use another camera</source>
        <translation>ta kamera tego nie potrafi; zaktualizuj jej oprogramowanie albo użyj innej kamery</translation>
    </message>
    <message>
        <source>set the camera to still pictures, end its plug-in or preview, close the telephone&apos;s application, and try again</source>
        <translation>ustaw kamerę na robienie zdjęć, zakończ jej wtyczkę lub podgląd, zamknij aplikację w telefonie i spróbuj jeszcze raz</translation>
    </message>
    <message>
        <source>the camera does not allow this value in its present mode</source>
        <translation>kamera nie pozwala na tę wartość w obecnym trybie</translation>
    </message>
    <message>
        <source>the file is damaged on the camera; take the photo again</source>
        <translation>plik w aparacie jest uszkodzony; zrób zdjęcie jeszcze raz</translation>
    </message>
    <message>
        <source>the camera is switching off; switch it on and resume</source>
        <translation>kamera się wyłącza; włącz ją i kontynuuj</translation>
    </message>
    <message>
        <source>wait a moment and try again</source>
        <translation>poczekaj chwilę i spróbuj jeszcze raz</translation>
    </message>
    <message>
        <source>switch the camera off and on, then resume</source>
        <translation>wyłącz kamerę i włącz, i kontynuuj</translation>
    </message>
    <message>
        <source>the shot was cancelled at the camera; take it again</source>
        <translation>zdjęcie przerwano przy aparacie; zrób je jeszcze raz</translation>
    </message>
    <message>
        <source>check that nobody has deleted the file from the camera</source>
        <translation>sprawdź, czy nikt nie usunął pliku z kamery</translation>
    </message>
    <message>
        <source>the camera has ended the session; switch it off and on, and close the telephone&apos;s application</source>
        <translation>kamera zakończyła sesję; wyłącz ją i włącz i zamknij aplikację w telefonie</translation>
    </message>
    <message>
        <source>close the other program or telephone that uses the camera; if none does, wait three minutes</source>
        <translation>zamknij inny program lub telefon, który używa kamery; jeśli żaden, poczekaj trzy minuty</translation>
    </message>
    <message>
        <source>the camera&apos;s storage is full; back its photos up and free some space</source>
        <translation>pamięć kamery jest pełna; skopiuj jej zdjęcia i zwolnij miejsce</translation>
    </message>
    <message>
        <source>it asks for a user name and a password (client mode), and was given none or wrong ones; give the right ones, or use the camera&apos;s own WiFi</source>
        <translation>prosi o nazwę użytkownika i hasło (tryb klienta), a dostała błędne lub żadne; podaj właściwe albo użyj sieci WiFi kamery</translation>
    </message>
    <message>
        <source>update the camera&apos;s firmware; if it stays so, report it</source>
        <translation>zaktualizuj oprogramowanie kamery; jeśli to nie pomoże, zgłoś to</translation>
    </message>
    <message>
        <source>The photo %1 is not usable: %2; %3.</source>
        <translation>Zdjęcia %1 nie można użyć: %2; %3.</translation>
    </message>
    <message>
        <source>fetch it from the camera again</source>
        <translation>pobierz je z kamery jeszcze raz</translation>
    </message>
    <message>
        <source>it has %1 bytes instead of %2</source>
        <translation>ma %1 bajtów zamiast %2</translation>
    </message>
    <message>
        <source>it is not a JPEG</source>
        <translation>nie jest plikiem JPEG</translation>
    </message>
    <message>
        <source>its end is missing</source>
        <translation>brakuje jego końca</translation>
    </message>
    <message>
        <source>its bytes are not those that were recorded (the SHA-256 differs)</source>
        <translation>jego bajty nie są tymi, które zapisano (różni się SHA-256)</translation>
    </message>
    <message>
        <source>it is not spherical, its %1 pixels are not twice as wide as high</source>
        <translation>nie jest sferyczne, jego %1 pikseli to nie dwa razy więcej szerokości niż wysokości</translation>
    </message>
    <message>
        <source>take or export it as a whole stitched sphere</source>
        <translation>zrób lub wyeksportuj je jako całą złożoną sferę</translation>
    </message>
    <message>
        <source>it is only %1 pixels wide, as a preview is; at least %2 are needed</source>
        <translation>ma tylko %1 pikseli szerokości, jak podgląd; potrzeba co najmniej %2</translation>
    </message>
    <message>
        <source>The photo %1 is in the survey already, as %2.</source>
        <translation>Zdjęcie %1 jest już w pomiarze, jako %2.</translation>
    </message>
    <message>
        <source>The picture %1 has %2 x %3 pixels, not the camera&apos;s %4 x %5.</source>
        <translation>Obraz %1 ma %2 x %3 pikseli, a nie %4 x %5 jak kamera.</translation>
    </message>
    <message>
        <source>%1 is in the survey already, as %2 at %3, %4 m from the place in the file.</source>
        <translation>%1 jest już w pomiarze, jako %2 przy %3, %4 m od miejsca z pliku.</translation>
    </message>
    <message>
        <source>%1 photos stand outside of the room&apos;s outline; check the outline and the positions.</source>
        <translation>%1 zdjęć leży poza obrysem pomieszczenia; sprawdź obrys i pozycje.</translation>
    </message>
    <message>
        <source>Could not read the positions %1: %2.</source>
        <translation>Nie udało się odczytać pozycji %1: %2.</translation>
    </message>
    <message>
        <source>Could not read %1: there is no such file or folder.</source>
        <translation>Nie udało się odczytać %1: nie ma takiego pliku.</translation>
    </message>
    <message>
        <source>Could not write %1: there is no such file or folder.</source>
        <translation>Nie udało się zapisać %1: nie ma takiego folderu.</translation>
    </message>
    <message>
        <source>Could not read %1: %2; check the permissions.</source>
        <translation>Nie udało się odczytać %1: %2; sprawdź uprawnienia.</translation>
    </message>
    <message>
        <source>Could not write %1: %2; check the permissions.</source>
        <translation>Nie udało się zapisać %1: %2; sprawdź uprawnienia.</translation>
    </message>
    <message>
        <source>Could not write %1: the disk is full; free some space and try again.</source>
        <translation>Nie udało się zapisać %1: dysk jest pełny; zwolnij miejsce i spróbuj jeszcze raz.</translation>
    </message>
    <message>
        <source>Could not write %1: it exists already.</source>
        <translation>Nie udało się zapisać %1: już istnieje.</translation>
    </message>
    <message>
        <source>Could not write %1; is the disk full?</source>
        <translation>Nie udało się zapisać %1; czy dysk jest pełny?</translation>
    </message>
    <message>
        <source>Could not write %1 %2: it exists already; choose another name, or remove it first.</source>
        <translation>Nie udało się zapisać %1 %2: już istnieje; wybierz inną nazwę albo najpierw to usuń.</translation>
    </message>
    <message>
        <source>Could not read %1: it is not a file.</source>
        <translation>Nie udało się odczytać %1: to nie jest plik.</translation>
    </message>
    <message>
        <source>Could not read %1: it ends too early; copy the file again.</source>
        <translation>Nie udało się odczytać %1: kończy się za wcześnie; skopiuj plik jeszcze raz.</translation>
    </message>
    <message>
        <source>Could not read %1: it has %2, more than the %3 that such a file may have.</source>
        <translation>Nie udało się odczytać %1: ma %2, więcej niż %3, które taki plik może mieć.</translation>
    </message>
    <message>
        <source>Could not read %1: it is not valid JSON.</source>
        <translation>Nie udało się odczytać %1: to nie jest poprawny JSON.</translation>
    </message>
    <message>
        <source>Could not read %1: it is neither a PNG nor a JPEG.</source>
        <translation>Nie udało się odczytać %1: to nie jest ani PNG, ani JPEG.</translation>
    </message>
    <message>
        <source>Could not read %1: the PNG is damaged, copy it again.</source>
        <translation>Nie udało się odczytać %1: PNG jest uszkodzony, skopiuj go jeszcze raz.</translation>
    </message>
    <message>
        <source>Could not make the folder %1: %2.</source>
        <translation>Nie udało się utworzyć folderu %1: %2.</translation>
    </message>
    <message>
        <source>Could not make a temporary folder %1: %2; set TMPDIR to a folder that can be written.</source>
        <translation>Nie udało się utworzyć tymczasowego folderu %1: %2; ustaw TMPDIR na folder, w którym można zapisywać.</translation>
    </message>
    <message>
        <source>Stopped on request; what was complete is kept.</source>
        <translation>Zatrzymano na życzenie; to, co było gotowe, pozostaje.</translation>
    </message>
    <message>
        <source>%1 is not a survey: %2; give a folder that Spherewalk has made.</source>
        <translation>%1 nie jest pomiarem: %2; podaj folder utworzony przez Spherewalk.</translation>
    </message>
    <message>
        <source>There is no survey %1; check the path.</source>
        <translation>Nie ma pomiaru %1; sprawdź ścieżkę.</translation>
    </message>
    <message>
        <source>Could not open the survey %1: %2.</source>
        <translation>Nie udało się otworzyć pomiaru %1: %2.</translation>
    </message>
    <message>
        <source>The survey&apos;s database %1 is empty.</source>
        <translation>Baza danych pomiaru %1 jest pusta.</translation>
    </message>
    <message>
        <source>The survey&apos;s database %1 is damaged: %2.</source>
        <translation>Baza danych pomiaru %1 jest uszkodzona: %2.</translation>
    </message>
    <message>
        <source>Restore it from a copy; the photos beside it are not affected.</source>
        <translation>Przywróć ją z kopii; zdjęcia obok nie ucierpiały.</translation>
    </message>
    <message>
        <source>The survey %1 was written by a newer Spherewalk (format %2, this one knows up to %3); update Spherewalk to open it.</source>
        <translation>Pomiar %1 zapisał nowszy Spherewalk (format %2, ten zna do %3); zaktualizuj Spherewalk, aby go otworzyć.</translation>
    </message>
    <message>
        <source>Could not create the survey %1: there is something by that name already; open it, or choose another name.</source>
        <translation>Nie udało się utworzyć pomiaru %1: coś o tej nazwie już istnieje; otwórz je albo wybierz inną nazwę.</translation>
    </message>
    <message>
        <source>Could not create the survey %1: %2.</source>
        <translation>Nie udało się utworzyć pomiaru %1: %2.</translation>
    </message>
    <message>
        <source>Could not create the folder %1: %2.</source>
        <translation>Nie udało się utworzyć folderu %1: %2.</translation>
    </message>
    <message>
        <source>Could not change the survey %1: it is open for reading only.</source>
        <translation>Nie udało się zmienić pomiaru %1: jest otwarty tylko do odczytu.</translation>
    </message>
    <message>
        <source>The survey %1 is being written by another program%2; close it there, or open it here for reading.</source>
        <translation>Pomiar %1 zapisuje właśnie inny program%2; zamknij go tam albo otwórz tutaj do odczytu.</translation>
    </message>
    <message>
        <source>The survey %1 is being written by another program; close it there, or open it here for reading.</source>
        <translation>Pomiar %1 zapisuje właśnie inny program; zamknij go tam albo otwórz tutaj do odczytu.</translation>
    </message>
    <message>
        <source>Could not open the survey %1 for writing: %2; check the permissions, or open it for reading.</source>
        <translation>Nie udało się otworzyć pomiaru %1 do zapisu: %2; sprawdź uprawnienia albo otwórz go do odczytu.</translation>
    </message>
    <message>
        <source>Could not lock the survey %1 for writing: %2.</source>
        <translation>Nie udało się zablokować pomiaru %1 do zapisu: %2.</translation>
    </message>
    <message>
        <source>Could not replace the plan of the survey %1: photos have been taken at its stations; create another survey for the new plan.</source>
        <translation>Nie udało się zastąpić planu pomiaru %1: na jego stanowiskach zrobiono już zdjęcia; utwórz inny pomiar dla nowego planu.</translation>
    </message>
    <message>
        <source>The outline cannot be used: %1.</source>
        <translation>Obrysu nie można użyć: %1.</translation>
    </message>
    <message>
        <source>The obstacle %1 cannot be used: %2.</source>
        <translation>Przeszkody %1 nie można użyć: %2.</translation>
    </message>
    <message>
        <source>the wall after corner %1 crosses the wall after corner %2</source>
        <translation>ściana za narożnikiem %1 przecina ścianę za narożnikiem %2</translation>
    </message>
    <message>
        <source>corners %1 and %2 are the same point</source>
        <translation>narożniki %1 i %2 to ten sam punkt</translation>
    </message>
    <message>
        <source>at corner %1 it turns back on itself</source>
        <translation>w narożniku %1 zawraca po sobie</translation>
    </message>
    <message>
        <source>it has %1 corners, and needs at least three</source>
        <translation>ma %1 narożników, a potrzebuje co najmniej trzech</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>współrzędna nie jest liczbą</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>nie ma powierzchni</translation>
    </message>
    <message>
        <source>The outline is %1 m long, more than the %2 m that one survey may have; check its unit (metres), or split the room.</source>
        <translation>Obrys ma %1 m długości, więcej niż %2 m, które może mieć jeden pomiar; sprawdź jednostkę (metry) albo podziel pomieszczenie.</translation>
    </message>
    <message>
        <source>The room has %1 corners, more than the %2 allowed; draw it more simply.</source>
        <translation>Pomieszczenie ma %1 narożników, więcej niż dozwolone %2; narysuj je prościej.</translation>
    </message>
    <message>
        <source>The obstacle %1 lies outside the outline; move it into the room or remove it.</source>
        <translation>Przeszkoda %1 leży poza obrysem; przesuń ją do pomieszczenia albo usuń.</translation>
    </message>
    <message>
        <source>The ceiling cannot be at %1 m: give its height above the floor, up to %2 m.</source>
        <translation>Sufit nie może być na %1 m: podaj jego wysokość nad podłogą, do %2 m.</translation>
    </message>
    <message>
        <source>A plan needs from one to %1 heights of the lens, not %2.</source>
        <translation>Plan potrzebuje od jednej do %1 wysokości obiektywu, a nie %2.</translation>
    </message>
    <message>
        <source>The lens cannot be at %1 m: give heights above the floor and below the ceiling, which is at %2 m.</source>
        <translation>Obiektyw nie może być na %1 m: podaj wysokości nad podłogą i pod sufitem, który jest na %2 m.</translation>
    </message>
    <message>
        <source>The height of %1 m is listed twice; list each height once.</source>
        <translation>Wysokość %1 m jest podana dwa razy; podaj każdą raz.</translation>
    </message>
    <message>
        <source>A step of %1 m is too fine for this room: %2.</source>
        <translation>Krok %1 m jest za mały dla tego pomieszczenia: %2.</translation>
    </message>
    <message>
        <source>A step of %1 m fits.</source>
        <translation>Pasuje krok %1 m.</translation>
    </message>
    <message>
        <source>it would take %1 stations, more than the %2 of one plan</source>
        <translation>wymagałby %1 stanowisk, więcej niż %2 w jednym planie</translation>
    </message>
    <message>
        <source>its bounds would hold more than %1 stops</source>
        <translation>jego granice objęłyby więcej niż %1 punktów</translation>
    </message>
    <message>
        <source>There is nothing to align in %1: no station has a photo yet; capture or import some first.</source>
        <translation>W %1 nie ma czego orientować: żadne stanowisko nie ma jeszcze zdjęcia; najpierw zrób lub zaimportuj zdjęcia.</translation>
    </message>
    <message>
        <source>No photo could be aligned, so no solution was recorded; see what is said of each photo.</source>
        <translation>Nie udało się wyznaczyć orientacji żadnego zdjęcia, więc nie zapisano rozwiązania; zobacz, co powiedziano o każdym zdjęciu.</translation>
    </message>
    <message>
        <source>The photos do not show where walls, floor and ceiling are, and no room is drawn: the dataset has no room.</source>
        <translation>Zdjęcia nie pokazują, gdzie są ściany, podłoga i sufit, a pomieszczenia nie narysowano: zbiór danych nie ma pomieszczenia.</translation>
    </message>
    <message>
        <source>The photos do not show where walls, floor and ceiling are: the dataset&apos;s room is the drawn one.</source>
        <translation>Zdjęcia nie pokazują, gdzie są ściany, podłoga i sufit: pomieszczenie zbioru danych to to narysowane.</translation>
    </message>
    <message>
        <source>Nothing can be exported.</source>
        <translation>Niczego nie można wyeksportować.</translation>
    </message>
    <message>
        <source>The heading of %1 of %2 photos is not known; they are exported as if each looked along the room&apos;s x axis.</source>
        <translation>Kierunek %1 z %2 zdjęć nie jest znany; są eksportowane tak, jakby patrzyły wzdłuż osi x pomieszczenia.</translation>
    </message>
    <message>
        <source>Could not keep a copy of the database as %1: %2.</source>
        <translation>Nie udało się zachować kopii bazy danych jako %1: %2.</translation>
    </message>
    <message>
        <source>The camera refused to %1 (&quot;%2&quot;): %3.</source>
        <translation>Kamera odmówiła (%1, &quot;%2&quot;): %3.</translation>
    </message>
    <message>
        <source>take the photo</source>
        <translation>zrobić zdjęcie</translation>
    </message>
    <message>
        <source>list its files</source>
        <translation>podać listę plików</translation>
    </message>
    <message>
        <source>describe itself</source>
        <translation>opisać się</translation>
    </message>
    <message>
        <source>show its preview</source>
        <translation>pokazać podgląd</translation>
    </message>
    <message>
        <source>speak API level 2</source>
        <translation>używać API poziomu 2</translation>
    </message>
    <message>
        <source>start a session</source>
        <translation>rozpocząć sesję</translation>
    </message>
    <message>
        <source>tell its settings</source>
        <translation>podać ustawienia</translation>
    </message>
    <message>
        <source>change its settings</source>
        <translation>zmienić ustawienia</translation>
    </message>
    <message>
        <source>tell its state</source>
        <translation>podać stan</translation>
    </message>
    <message>
        <source>The room &quot;%1&quot; lies outside the outline; move its name into the room or remove it.</source>
        <translation>Pomieszczenie &quot;%1&quot; leży poza obrysem; wpisz jego nazwę wewnątrz albo ją usuń.</translation>
    </message>
    <message>
        <source>A room cannot be called &quot;%1&quot;: give one line of up to %2 letters.</source>
        <translation>Pomieszczenie nie może nazywać się &quot;%1&quot;: podaj jeden wiersz do %2 liter.</translation>
    </message>
    <message>
        <source>The plan names %1 rooms, more than the %2 allowed.</source>
        <translation>Plan nazywa %1 pomieszczeń, więcej niż dozwolone %2.</translation>
    </message>
    <message>
        <source>Rail %1 cannot lie there: it leaves the floor, or meets a wall or an obstacle; move it, or make it shorter.</source>
        <translation>Szyna %1 nie może tam leżeć: wychodzi poza podłogę albo trafia na ścianę lub przeszkodę; przesuń ją lub skróć.</translation>
    </message>
    <message>
        <source>Rails %1 and %2 have a stop at the same place; move one of them.</source>
        <translation>Szyny %1 i %2 mają postój w tym samym miejscu; przesuń jedną z nich.</translation>
    </message>
    <message>
        <source>Could not read %1: it has no faces (lines &quot;f 1 2 3&quot;); export the mesh as OBJ.</source>
        <translation>Nie udało się odczytać %1: brak ścian (wierszy „f 1 2 3”); wyeksportuj siatkę jako OBJ.</translation>
    </message>
    <message>
        <source>Could not read %1: a face names vertex %2 of %3; export the mesh again.</source>
        <translation>Nie udało się odczytać %1: ściana podaje wierzchołek %2 z %3; wyeksportuj siatkę ponownie.</translation>
    </message>
    <message>
        <source>Could not read %1: all of its points are the same; export the mesh again.</source>
        <translation>Nie udało się odczytać %1: wszystkie punkty są takie same; wyeksportuj siatkę ponownie.</translation>
    </message>
    <message>
        <source>Could not read %1: line %2 is no vertex (&quot;v x y z&quot;); export the mesh again.</source>
        <translation>Nie udało się odczytać %1: wiersz %2 nie jest wierzchołkiem („v x y z”); wyeksportuj siatkę ponownie.</translation>
    </message>
    <message>
        <source>Could not read %1: line %2 is no face (&quot;f 1 2 3&quot;); export the mesh again.</source>
        <translation>Nie udało się odczytać %1: wiersz %2 nie jest ścianą („f 1 2 3”); wyeksportuj siatkę ponownie.</translation>
    </message>
    <message>
        <source>Could not read %1: it has more than %2 triangles; make it simpler.</source>
        <translation>Nie udało się odczytać %1: ma więcej niż %2 trójkątów; uprość siatkę.</translation>
    </message>
    <message>
        <source>No photo is left to export; capture some first, or accept some.</source>
        <translation>Nie zostało żadne zdjęcie do eksportu; najpierw zrób zdjęcia albo jakieś zaakceptuj.</translation>
    </message>
    <message>
        <source>How much space is left at %1 cannot be told.</source>
        <translation>Nie wiadomo, ile miejsca zostało w %1.</translation>
    </message>
    <message>
        <source>The dataset needs about %1, and %2 are free at %3; make space, or choose another place.</source>
        <translation>Zbiór danych potrzebuje około %1, a w %3 wolne jest %2; zwolnij miejsce albo wybierz inne.</translation>
    </message>
    <message>
        <source>The survey is not aligned: photos would be exported as if each looked along the room&apos;s x axis; align it first.</source>
        <translation>Orientacja zdjęć nie jest wyznaczona: zdjęcia byłyby wyeksportowane tak, jakby każde patrzyło wzdłuż osi x pomieszczenia; najpierw ją wyznacz.</translation>
    </message>
    <message>
        <source>1 photo has no known heading: it would be exported as if it looked along the room&apos;s x axis; align again, or reject it.</source>
        <translation>1 zdjęcie ma nieznany kierunek: byłoby wyeksportowane tak, jakby patrzyło wzdłuż osi x pomieszczenia; wyznacz orientację ponownie albo je odrzuć.</translation>
    </message>
    <message>
        <source>No other photo shares enough with it that a third one confirms: it seems to be of another place.</source>
        <translation>Żadne inne zdjęcie nie ma z nim dość wspólnego, co potwierdziłoby trzecie: wydaje się pochodzić z innego miejsca.</translation>
    </message>
    <message>
        <source>Leave it out, or take photos between it and the others.</source>
        <translation>Pomiń je albo zrób zdjęcia pomiędzy nim a pozostałymi.</translation>
    </message>
    <message>
        <source>It was taken at one place with the others, so nothing tells how far things are: take others half a metre from it.</source>
        <translation>Zrobiono je w tym samym miejscu co inne, więc nic nie mówi, jak daleko są rzeczy: zrób inne pół metra od niego.</translation>
    </message>
    <message>
        <source>Take photos between them.</source>
        <translation>Zrób zdjęcia pomiędzy nimi.</translation>
    </message>
    <message>
        <source>The other photo shares too little with it: it seems to be of another place.</source>
        <translation>Drugie zdjęcie ma z nim zbyt mało wspólnego: wydaje się pochodzić z innego miejsca.</translation>
    </message>
    <message>
        <source>It is the only photo, and nothing tells how far things are: take others half a metre from it.</source>
        <translation>To jedyne zdjęcie i nic nie mówi, jak daleko są rzeczy: zrób inne pół metra od niego.</translation>
    </message>
    <message>
        <source>It belongs to part %1 of %2, which shares nothing certain with the largest part: take photos between the parts.</source>
        <translation>Należy do części %1 z %2, która nie ma nic pewnego wspólnego z największą częścią: zrób zdjęcia pomiędzy częściami.</translation>
    </message>
    <message>
        <source>How far it is from the others is not known: it shares too little with two of them at a time.</source>
        <translation>Nie wiadomo, jak daleko jest od pozostałych: ma zbyt mało wspólnego z dwoma z nich jednocześnie.</translation>
    </message>
    <message>
        <source>Take another photo near it.</source>
        <translation>Zrób kolejne zdjęcie w jego pobliżu.</translation>
    </message>
    <message>
        <source>Little confirms where it was taken: it shares %1 points with %2 other photos.</source>
        <translation>Niewiele potwierdza, gdzie je zrobiono: wspólne punkty: %1, inne zdjęcia: %2.</translation>
    </message>
    <message>
        <source>Where it was taken is known to %1 cm and %2 deg only: take another photo near it.</source>
        <translation>Miejsce, w którym je zrobiono, jest znane tylko z dokładnością do %1 cm i %2 stopnia: zrób kolejne zdjęcie w jego pobliżu.</translation>
    </message>
    <message>
        <source>Two ways of solving turn it %1 deg apart: take another photo near it.</source>
        <translation>Dwa sposoby rozwiązania obracają je o %1 stopnia inaczej: zrób kolejne zdjęcie w jego pobliżu.</translation>
    </message>
    <message>
        <source>It shows some things that the largest part shows, but not what stands around them: it seems to be of another place that looks alike.</source>
        <translation>Pokazuje niektóre rzeczy, które widać w największej części, ale nie to, co stoi wokół nich: wydaje się pochodzić z innego, podobnego miejsca.</translation>
    </message>
    <message>
        <source>Little of what the largest part lets expect around it is there, so how it stands to the others is not certain: take photos between it and them.</source>
        <translation>Niewiele z tego, czego największa część każe się wokół niego spodziewać, tam jest, więc jego położenie względem pozostałych nie jest pewne: zrób zdjęcia pomiędzy nim a nimi.</translation>
    </message>
    <message>
        <source>The floor around it lies %1 cm above that of the largest part: if there is no step, lengths around it are %2 % too short.</source>
        <translation>Podłoga wokół niego leży %1 cm powyżej podłogi największej części: jeśli nie ma tam stopnia, długości wokół niego są o %2 % za krótkie.</translation>
    </message>
    <message>
        <source>The floor around it lies %1 cm below that of the largest part: if there is no step, lengths around it are %2 % too long.</source>
        <translation>Podłoga wokół niego leży %1 cm poniżej podłogi największej części: jeśli nie ma tam stopnia, długości wokół niego są o %2 % za długie.</translation>
    </message>
    <message>
        <source>Take photos between it and the others.</source>
        <translation>Zrób zdjęcia pomiędzy nim a pozostałymi.</translation>
    </message>
    <message>
        <source>Looking for faces in photo %1 of %2</source>
        <translation>Szukam twarzy na zdjęciu %1 z %2</translation>
    </message>
    <message>
        <source>Faces cannot be looked for: there is no file %1.</source>
        <translation>Nie można szukać twarzy: nie ma pliku %1.</translation>
    </message>
    <message>
        <source>Install the package opencv-data, or mark the regions yourself.</source>
        <translation>Zainstaluj pakiet opencv-data albo zaznacz obszary samodzielnie.</translation>
    </message>
    <message>
        <source>The file %1 is no cascade.</source>
        <translation>Plik %1 nie jest kaskadą.</translation>
    </message>
    <message>
        <source>The survey&apos;s disk has room for about %1 of the %2 photos that are still to be taken; make space before you go on.</source>
        <translation>Na dysku pomiaru jest miejsce na około %1 z %2 zdjęć, które jeszcze trzeba zrobić; zwolnij miejsce, zanim pójdziesz dalej.</translation>
    </message>
    <message>
        <source>None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the scene model %3, reaches %4 px.</source>
        <translation>Żaden ze zbadanych kroków nie utrzymuje %1 px w 95 ze 100 miejsc; najlepszy, %2 cm z modelem sceny %3, osiąga %4 px.</translation>
    </message>
    <message>
        <source>None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the scene model %3, misses more than 5 of 100 places.</source>
        <translation>Żaden ze zbadanych kroków nie utrzymuje %1 px w 95 ze 100 miejsc; najlepszy, %2 cm z modelem sceny %3, chybia w więcej niż 5 ze 100 miejsc.</translation>
    </message>
    <message>
        <source>Study a denser block, or allow more.</source>
        <translation>Zbadaj gęstszy blok albo dopuść więcej.</translation>
    </message>
    <message>
        <source>For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3 (no coarser one was studied): %4 photos, about %5.</source>
        <translation>Dla %1 px w 95 ze 100 miejsc wystarcza siatka %2 cm z modelem sceny %3 (rzadszej nie zbadano): %4 zdjęć, około %5.</translation>
    </message>
    <message>
        <source>For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3: %4 photos, about %5.</source>
        <translation>Dla %1 px w 95 ze 100 miejsc wystarcza siatka %2 cm z modelem sceny %3: %4 zdjęć, około %5.</translation>
    </message>
    <message>
        <source>Looking for features</source>
        <translation>Szukanie cech</translation>
    </message>
    <message>
        <source>Matching photos</source>
        <translation>Dopasowywanie zdjęć</translation>
    </message>
    <message>
        <source>Looking for AprilTags</source>
        <translation>Szukanie AprilTagów</translation>
    </message>
    <message>
        <source>Looking for photos that look alike</source>
        <translation>Szukanie podobnych zdjęć</translation>
    </message>
    <message>
        <source>Averaging rotations</source>
        <translation>Uśrednianie obrotów</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Rozwiązywanie</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Rozwiązano</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Położenia znalezione</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Wyrównano</translation>
    </message>
    <message>
        <source>Reading what the photos say</source>
        <translation>Odczyt danych ze zdjęć</translation>
    </message>
    <message>
        <source>Estimating how neighbours are turned to each other</source>
        <translation>Szacowanie obrotów między sąsiadami</translation>
    </message>
    <message>
        <source>Checking the positions</source>
        <translation>Sprawdzanie położeń</translation>
    </message>
    <message>
        <source>Looking for what moved</source>
        <translation>Szukanie tego, co się poruszyło</translation>
    </message>
    <message>
        <source>Looking for what stands where other photos look through</source>
        <translation>Szukanie tego, co stoi tam, gdzie inne zdjęcia widzą na wskroś</translation>
    </message>
    <message>
        <source>Writing the photos&apos; position tags</source>
        <translation>Zapis położeń w zdjęciach</translation>
    </message>
    <message>
        <source>Retagged</source>
        <translation>Przypisano na nowo</translation>
    </message>
    <message>
        <source>Photo %1 of %2, %3</source>
        <translation>Zdjęcie %1 z %2, %3</translation>
    </message>
    <message>
        <source>Judging photo %1 of %2</source>
        <translation>Ocena zdjęcia %1 z %2</translation>
    </message>
    <message>
        <source>Importing photo %1 of %2</source>
        <translation>Import zdjęcia %1 z %2</translation>
    </message>
    <message>
        <source>Looking at the place of %1</source>
        <translation>Sprawdzanie miejsca zdjęcia %1</translation>
    </message>
    <message>
        <source>Looked at all places</source>
        <translation>Wszystkie miejsca sprawdzone</translation>
    </message>
    <message>
        <source>Writing photo %1 of %2</source>
        <translation>Zapis zdjęcia %1 z %2</translation>
    </message>
    <message>
        <source>Estimating depth, photo %1 of %2</source>
        <translation>Szacowanie głębi, zdjęcie %1 z %2</translation>
    </message>
    <message>
        <source>Clearing the floor below the camera, photo %1 of %2</source>
        <translation>Odsłanianie podłogi pod aparatem, zdjęcie %1 z %2</translation>
    </message>
    <message>
        <source>Trying one photo</source>
        <translation>Próba na jednym zdjęciu</translation>
    </message>
    <message>
        <source>Trying one depth</source>
        <translation>Próba jednej głębi</translation>
    </message>
    <message>
        <source>Looking at the survey</source>
        <translation>Przegląd pomiaru</translation>
    </message>
    <message>
        <source>Making boxes of furniture</source>
        <translation>Tworzenie brył mebli</translation>
    </message>
    <message>
        <source>Finding surfaces</source>
        <translation>Szukanie powierzchni</translation>
    </message>
    <message>
        <source>Reading depth %1 of %2</source>
        <translation>Odczyt głębi %1 z %2</translation>
    </message>
    <message>
        <source>Painting surfaces, photo %1 of %2</source>
        <translation>Kolorowanie powierzchni, zdjęcie %1 z %2</translation>
    </message>
    <message>
        <source>Fusing depths</source>
        <translation>Łączenie głębi</translation>
    </message>
    <message>
        <source>Looking which photos see each other</source>
        <translation>Szukanie zdjęć, które widzą się nawzajem</translation>
    </message>
    <message>
        <source>Drawing picture %1 of %2</source>
        <translation>Rysowanie obrazu %1 z %2</translation>
    </message>
    <message>
        <source>Rendering the walk</source>
        <translation>Obliczanie przejazdu</translation>
    </message>
    <message>
        <source>Registering picture %1 of %2 by its tags</source>
        <translation>Pasowanie obrazu %1 z %2 do znaczników</translation>
    </message>
    <message>
        <source>Comparing picture %1 of %2 again</source>
        <translation>Ponowne porównanie obrazu %1 z %2</translation>
    </message>
    <message>
        <source>Comparing picture %1 of %2</source>
        <translation>Porównanie obrazu %1 z %2</translation>
    </message>
    <message>
        <source>Comparing border %1 of %2</source>
        <translation>Porównanie granicy %1 z %2</translation>
    </message>
    <message>
        <source>Comparing view %1 of %2</source>
        <translation>Porównanie widoku %1 z %2</translation>
    </message>
    <message>
        <source>Grid of %1: comparing view %2 of %3</source>
        <translation>Siatka %1: porównanie widoku %2 z %3</translation>
    </message>
    <message>
        <source>Comparing with the exact room</source>
        <translation>Porównanie z dokładnym pokojem</translation>
    </message>
    <message>
        <source>Timing views</source>
        <translation>Pomiar czasu widoków</translation>
    </message>
    <message>
        <source>Checking the dataset</source>
        <translation>Sprawdzanie zbioru danych</translation>
    </message>
    <message>
        <source>Checking the database</source>
        <translation>Sprawdzanie bazy danych</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Sprawdzono</translation>
    </message>
    <message>
        <source>rail %1, stop %2</source>
        <translation>Szyna %1, postój %2</translation>
    </message>
    <message>
        <source>Checking %1</source>
        <translation>Sprawdzanie %1</translation>
    </message>
    <message>
        <source>Foretelling how far views are off</source>
        <translation>Przewidywanie błędów widoków</translation>
    </message>
    <message>
        <source>Most of what the photos show stands more than half a metre beyond the drawn outline, which is too small or of another room: the dataset has the room that the photos show.</source>
        <translation>Większość tego, co widać na zdjęciach, leży ponad pół metra poza narysowanym obrysem, który jest za mały albo należy do innego pomieszczenia: zbiór danych ma pomieszczenie widoczne na zdjęciach.</translation>
    </message>
    <message>
        <source>The places were solved from the pictures.</source>
        <translation>Miejsca obliczono ze zdjęć.</translation>
    </message>
    <message>
        <source>The height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one standard deviation).</source>
        <translation>Skalę daje wysokość obiektywu nad obliczoną podłogą, %1 m, z dokładnością do %2 % (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>A guessed height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one standard deviation).</source>
        <translation>Skalę daje zgadywana wysokość obiektywu nad obliczoną podłogą, %1 m, z dokładnością do %2 % (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>The scale is known to %1 % (one standard deviation).</source>
        <translation>Skala jest znana z dokładnością do %1 % (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>The given distance gives the scale, to %1 % (one standard deviation).</source>
        <translation>Skalę daje podana odległość, z dokładnością do %1 % (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>The printed size of the tags gives the scale, to %1 % (one standard deviation).</source>
        <translation>Skalę daje rozmiar wydrukowanych znaczników, z dokładnością do %1 % (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>Nothing gives the scale.</source>
        <translation>Nic nie daje skali.</translation>
    </message>
    <message>
        <source>Where the photos were taken is not known yet.</source>
        <translation>Nie wiadomo jeszcze, gdzie zrobiono zdjęcia.</translation>
    </message>
    <message>
        <source>Of the last photo: %1</source>
        <translation>O ostatnim zdjęciu: %1</translation>
    </message>
    <message>
        <source>The position tags are stated to be too rough for any other.</source>
        <translation>Podane położenia są według opisu zbyt niedokładne dla każdego innego.</translation>
    </message>
    <message>
        <source>What its neighbours see there stands about %1 degrees away in this photo: it moved.</source>
        <translation>To, co widzą tam sąsiednie zdjęcia, na tym zdjęciu stoi około %1 stopni dalej: zostało przesunięte.</translation>
    </message>
    <message>
        <source>What its neighbours see there is not in this photo: it moved, vanished or is covered.</source>
        <translation>Tego, co widzą tam sąsiednie zdjęcia, na tym zdjęciu nie ma: zostało przesunięte, zniknęło albo jest zasłonięte.</translation>
    </message>
    <message>
        <source>one stop farther along its rail than its tag says</source>
        <translation>o jeden przystanek dalej na szynie, niż podano</translation>
    </message>
    <message>
        <source>one stop before the one that its tag says</source>
        <translation>o jeden przystanek wcześniej, niż podano</translation>
    </message>
    <message>
        <source>It is one of %1 photos taken %2: it shows what is seen from %3.</source>
        <translation>To jedno z %1 zdjęć zrobionych %2: pokazuje to, co widać z %3.</translation>
    </message>
    <message>
        <source>It was taken about %1 m from where its tag says, where no photo is planned: one stop off the end of its rail.</source>
        <translation>Zrobiono je około %1 m od podanego miejsca, tam gdzie nie zaplanowano zdjęcia: jeden przystanek za końcem szyny.</translation>
    </message>
    <message>
        <source>It was taken about %1 m from where its tag says, where no photo is planned.</source>
        <translation>Zrobiono je około %1 m od podanego miejsca, tam gdzie nie zaplanowano zdjęcia.</translation>
    </message>
    <message>
        <source>It was taken %1: it shows what is seen from %2.</source>
        <translation>Zrobiono je %1: pokazuje to, co widać z %2.</translation>
    </message>
    <message>
        <source>Its rail was walked from the other end: it shows what is seen from %1.</source>
        <translation>Szynę przejechano od drugiego końca: zdjęcie pokazuje to, co widać z %1.</translation>
    </message>
    <message>
        <source>It shows what is seen from %1; the photo tagged so shows %2: they are swapped.</source>
        <translation>Pokazuje to, co widać z %1; zdjęcie podane w tym miejscu pokazuje %2: są zamienione.</translation>
    </message>
    <message>
        <source>It shows what is seen from %1.</source>
        <translation>Pokazuje to, co widać z %1.</translation>
    </message>
    <message>
        <source>It would lean by %1 deg from what its camera states of its tilt.</source>
        <translation>Byłoby przechylone o %1 stopni względem pochylenia, które podaje aparat.</translation>
    </message>
    <message>
        <source>It would lean by %1 deg from upright, though it states no tilt.</source>
        <translation>Byłoby przechylone o %1 stopni od pionu, choć nie podaje pochylenia.</translation>
    </message>
    <message>
        <source>Its rotation is therefore not known: check its position, and retake it if that is right.</source>
        <translation>Dlatego jego obrót nie jest znany: sprawdź położenie i zrób je ponownie, jeśli położenie się zgadza.</translation>
    </message>
    <message>
        <source>Its rotation is therefore not known: take another photo beside it.</source>
        <translation>Dlatego jego obrót nie jest znany: zrób obok jeszcze jedno zdjęcie.</translation>
    </message>
    <message>
        <source>All photos of %1 lie on one line.</source>
        <translation>Wszystkie zdjęcia %1 leżą na jednej linii.</translation>
    </message>
    <message>
        <source>Nothing but the tilts that they state holds the turn about that line, which is known to %1 deg (one standard deviation).</source>
        <translation>Obrót wokół tej linii wynika tylko z podanych pochyleń i jest znany do %1 stopnia (jedno odchylenie standardowe).</translation>
    </message>
    <message>
        <source>Add a second rail, or one photo, beside the line.</source>
        <translation>Dodaj drugą szynę albo jedno zdjęcie obok tej linii.</translation>
    </message>
    <message>
        <source>%1 of %2 photos lean by more than 3 degrees from what they state, or from upright if they state nothing.</source>
        <translation>%1 z %2 zdjęć odchyla się o więcej niż 3 stopnie od tego, co podają, albo od pionu, jeśli nic nie podają.</translation>
    </message>
    <message>
        <source>Most leans %1: by %2 deg.</source>
        <translation>Najbardziej przechylone jest %1: o %2 stopnia.</translation>
    </message>
    <message>
        <source>If the camera stood level, look at these photos, and at their positions.</source>
        <translation>Jeśli aparat stał prosto, sprawdź te zdjęcia i ich położenia.</translation>
    </message>
    <message>
        <source>Half a turn about the line to its neighbours explains what it shows about as well.</source>
        <translation>Pół obrotu wokół linii do sąsiednich zdjęć wyjaśnia to, co pokazuje, mniej więcej równie dobrze.</translation>
    </message>
    <message>
        <source>Which way it looks is not known: too little of what it shares with its neighbours lies clearly in front of them, so half a turn explains it as well.</source>
        <translation>Nie wiadomo, w którą stronę jest zwrócone: zbyt mało tego, co ma wspólne z sąsiednimi zdjęciami, leży wyraźnie przed nimi, więc pół obrotu wyjaśnia to równie dobrze.</translation>
    </message>
    <message>
        <source>Take a photo between them, or nearer to things.</source>
        <translation>Zrób zdjęcie pomiędzy nimi albo bliżej przedmiotów.</translation>
    </message>
    <message>
        <source>How it is turned against the others is not known: its position asks for another turn than what it shows in common with its neighbours.</source>
        <translation>Nie wiadomo, jak jest obrócone względem innych: jego położenie wymaga innego obrotu niż to, co pokazuje wspólnie z sąsiednimi zdjęciami.</translation>
    </message>
    <message>
        <source>Check the positions.</source>
        <translation>Sprawdź położenia.</translation>
    </message>
    <message>
        <source>Its matches contradict where the other photos are.</source>
        <translation>To, co pokazuje wspólnie z innymi, przeczy ich położeniom.</translation>
    </message>
    <message>
        <source>Check its position tag.</source>
        <translation>Sprawdź podane położenie.</translation>
    </message>
    <message>
        <source>There is no other photo to compare it with.</source>
        <translation>Nie ma innego zdjęcia do porównania.</translation>
    </message>
    <message>
        <source>It was compared with no other photo.</source>
        <translation>Nie porównano go z żadnym innym zdjęciem.</translation>
    </message>
    <message>
        <source>No neighbour shares enough with it.</source>
        <translation>Żadne sąsiednie zdjęcie nie ma z nim dość wspólnego.</translation>
    </message>
    <message>
        <source>Compared with %1 photos, it shares enough with %2, and nothing confirms that.</source>
        <translation>Porównane ze zdjęciami (%1), ma dość wspólnego z %2, a nic tego nie potwierdza.</translation>
    </message>
    <message>
        <source>What its neighbours say of it contradicts what they say of each other.</source>
        <translation>To, co mówią o nim sąsiednie zdjęcia, przeczy temu, co mówią o sobie nawzajem.</translation>
    </message>
    <message>
        <source>The survey falls into %1 parts that share no photo pair; part %2 is %3.</source>
        <translation>Pomiar rozpada się na %1 części bez wspólnej pary zdjęć; część %2 to %3.</translation>
    </message>
    <message>
        <source>Each part is aligned for itself, by its positions: take photos between them.</source>
        <translation>Każda część jest orientowana osobno według swoich położeń: zrób zdjęcia pomiędzy nimi.</translation>
    </message>
    <message>
        <source>Nothing fixes the common heading of %1: they stand at one place.</source>
        <translation>Nic nie wyznacza wspólnego kierunku %1: stoją w jednym miejscu.</translation>
    </message>
    <message>
        <source>Only how they are turned to each other is known.</source>
        <translation>Wiadomo tylko, jak są obrócone względem siebie.</translation>
    </message>
    <message>
        <source>The positions of %1 contradict what the photos show of them (%2 % of the directions agree).</source>
        <translation>Położenia %1 przeczą temu, co pokazują zdjęcia (zgadza się %2 % kierunków).</translation>
    </message>
    <message>
        <source>They seem to be off by about %1 m.</source>
        <translation>Wydają się błędne o około %1 m.</translation>
    </message>
    <message>
        <source>Check the position tags, or state how rough they are.</source>
        <translation>Sprawdź podane położenia albo podaj, jak bardzo są niedokładne.</translation>
    </message>
    <message>
        <source>The alignment of %1 is doubtful: only %2 % of the matches that pairs agreed on fit it.</source>
        <translation>Orientacja %1 jest wątpliwa: pasuje do niej tylko %2 % dopasowań, co do których pary były zgodne.</translation>
    </message>
    <message>
        <source>The photos fall into %1 parts that share nothing certain; part %2 is %3.</source>
        <translation>Zdjęcia rozpadają się na %1 części, które nie mają nic pewnego wspólnego; część %2 to %3.</translation>
    </message>
    <message>
        <source>Only the largest part is placed: take photos between the parts.</source>
        <translation>Położenia otrzymuje tylko największa część: zrób zdjęcia pomiędzy częściami.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the given distance is %1 % too long.</source>
        <translation>Według wydrukowanego rozmiaru znaczników podana odległość jest za duża o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the given distance is %1 % too short.</source>
        <translation>Według wydrukowanego rozmiaru znaczników podana odległość jest za mała o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the height of the lens is %1 % too long.</source>
        <translation>Według wydrukowanego rozmiaru znaczników wysokość obiektywu jest za duża o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, the height of the lens is %1 % too short.</source>
        <translation>Według wydrukowanego rozmiaru znaczników wysokość obiektywu jest za mała o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, lengths in the other survey&apos;s frame are %1 % too long.</source>
        <translation>Według wydrukowanego rozmiaru znaczników długości w drugim pomiarze są za duże o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, lengths in the other survey&apos;s frame are %1 % too short.</source>
        <translation>Według wydrukowanego rozmiaru znaczników długości w drugim pomiarze są za małe o %1 %.</translation>
    </message>
    <message>
        <source>By the printed size of the tags, all tapes are %1 % too long (known to %2 %).</source>
        <translation>Według wydrukowanego rozmiaru znaczników wszystkie miary są za długie o %1 % (znane do %2 %).</translation>
    </message>
    <message>
        <source>By the printed size of the tags, all tapes are %1 % too short (known to %2 %).</source>
        <translation>Według wydrukowanego rozmiaru znaczników wszystkie miary są za krótkie o %1 % (znane do %2 %).</translation>
    </message>
    <message>
        <source>Measure the printed tags and the distance again.</source>
        <translation>Zmierz ponownie wydrukowane znaczniki i odległość.</translation>
    </message>
    <message>
        <source>Measure the printed tags, and the height of the lens.</source>
        <translation>Zmierz wydrukowane znaczniki i wysokość obiektywu.</translation>
    </message>
    <message>
        <source>Measure a printed tag with a ruler, then the tapes.</source>
        <translation>Zmierz wydrukowany znacznik linijką, a potem taśmy miernicze.</translation>
    </message>
    <message>
        <source>Perhaps a tag was moved between the surveys, or the size of their tags was given differently.</source>
        <translation>Być może między pomiarami przewieszono znacznik albo podano różne rozmiary znaczników.</translation>
    </message>
    <message>
        <source>AprilTag %1 hangs elsewhere than in the other survey, and was not used to join them.</source>
        <translation>AprilTag %1 wisi gdzie indziej niż w drugim pomiarze i nie użyto go do ich połączenia.</translation>
    </message>
    <message>
        <source>Hang tags where nobody moves them.</source>
        <translation>Wieszaj znaczniki tam, gdzie nikt ich nie przesunie.</translation>
    </message>
    <message>
        <source>The scale is not known: the photos show too little of the floor below them, and no distance was given.</source>
        <translation>Skala nie jest znana: zdjęcia pokazują zbyt mało podłogi pod nimi i nie podano żadnej odległości.</translation>
    </message>
    <message>
        <source>Give the distance between two photos.</source>
        <translation>Podaj odległość między dwoma zdjęciami.</translation>
    </message>
    <message>
        <source>Nobody said how high the lens stands over the floor: %1 m is a guess, and all lengths may be wrong by a quarter and more.</source>
        <translation>Nikt nie podał, jak wysoko nad podłogą stoi obiektyw: %1 m to przypuszczenie, a wszystkie długości mogą być błędne o jedną czwartą i więcej.</translation>
    </message>
    <message>
        <source>Give the height of the lens, or the distance between two photos.</source>
        <translation>Podaj wysokość obiektywu albo odległość między dwoma zdjęciami.</translation>
    </message>
    <message>
        <source>All lengths are known to %1 % alone (one standard deviation): align the survey with a known height of the lens, or a known distance, and export again.</source>
        <translation>Wszystkie długości są znane tylko z dokładnością do %1 % (jedno odchylenie standardowe): wyrównaj pomiar ze znaną wysokością obiektywu lub znaną odległością i wyeksportuj ponownie.</translation>
    </message>
    <message>
        <source>Nobody has drawn the room: its walls are a rectangle around what the photos show.</source>
        <translation>Nikt nie narysował pomieszczenia: jego ściany to prostokąt wokół tego, co pokazują zdjęcia.</translation>
    </message>
    <message>
        <source>The world of a dataset with depth has walls as they stand.</source>
        <translation>Świat ze zbioru z głębią ma ściany takie, jakie stoją.</translation>
    </message>
    <message>
        <source>Where AprilTag %1 hangs is not known: 1 photo sees it (%2), but not from places far enough apart.</source>
        <translation>Nie wiadomo, gdzie wisi AprilTag %1: widzi go 1 zdjęcie (%2), ale nie z dostatecznie odległych miejsc.</translation>
    </message>
    <message>
        <source>Where AprilTag %1 hangs is not known: %2 photos see it (%3), but not from places far enough apart.</source>
        <translation>Nie wiadomo, gdzie wisi AprilTag %1: liczba zdjęć, które go widzą: %2 (%3), ale nie z dostatecznie odległych miejsc.</translation>
    </message>
    <message>
        <source>Take a photo near it.</source>
        <translation>Zrób zdjęcie w jego pobliżu.</translation>
    </message>
    <message>
        <source>AprilTag %1 hangs in more than one place, or was moved: %2 photos see it at (%3, %4, %5), but %6 elsewhere.</source>
        <translation>AprilTag %1 wisi w kilku miejscach albo go przewieszono: liczba zdjęć, które widzą go w (%3; %4; %5): %2, ale %6 gdzie indziej.</translation>
    </message>
    <message>
        <source>Hang each number once.</source>
        <translation>Każdy numer powieś tylko raz.</translation>
    </message>
    <message>
        <source>No AprilTag was found that two photos see: hang tags where photos see them from up to 4 m away, or leave out --tag-size.</source>
        <translation>Nie znaleziono AprilTagu, który widzą dwa zdjęcia: powieś znaczniki tam, gdzie zdjęcia widzą je z odległości do 4 m, albo nie podawaj rozmiaru.</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the left of the picture&apos;s middle, %2 degrees above the horizon (%3 % of the sphere).</source>
        <translation>Coś stoi tam, gdzie inne zdjęcia widzą na wylot: %1 stopni w lewo od środka obrazu, %2 stopni nad horyzontem (%3 % sfery).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the left of the picture&apos;s middle, %2 degrees below the horizon (%3 % of the sphere).</source>
        <translation>Coś stoi tam, gdzie inne zdjęcia widzą na wylot: %1 stopni w lewo od środka obrazu, %2 stopni pod horyzontem (%3 % sfery).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the right of the picture&apos;s middle, %2 degrees above the horizon (%3 % of the sphere).</source>
        <translation>Coś stoi tam, gdzie inne zdjęcia widzą na wylot: %1 stopni w prawo od środka obrazu, %2 stopni nad horyzontem (%3 % sfery).</translation>
    </message>
    <message>
        <source>Something stands where other photos look through: %1 degrees to the right of the picture&apos;s middle, %2 degrees below the horizon (%3 % of the sphere).</source>
        <translation>Coś stoi tam, gdzie inne zdjęcia widzą na wylot: %1 stopni w prawo od środka obrazu, %2 stopni pod horyzontem (%3 % sfery).</translation>
    </message>
    <message>
        <source>If it is a person, step aside and take it again.</source>
        <translation>Jeśli to osoba, odejdź na bok i zrób je ponownie.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read; retake the photo.</source>
        <translation>Nie można odczytać pliku %1; zrób zdjęcie ponownie.</translation>
    </message>
    <message>
        <source>The position tags are mirrored: one axis points the wrong way, or x and y are exchanged.</source>
        <translation>Podane położenia są odbite: jedna oś jest odwrócona albo x i y są zamienione.</translation>
    </message>
    <message>
        <source>No photo is aligned; correct the axis in all positions, and align again.</source>
        <translation>Żadne zdjęcie nie jest zorientowane; popraw oś we wszystkich położeniach i zorientuj ponownie.</translation>
    </message>
    <message>
        <source>The scale of the tags differs along the axes: against x, the tags are %1 times as long along y as the photos show.</source>
        <translation>Skala położeń różni się wzdłuż osi: względem x są wzdłuż y %1 razy dłuższe, niż pokazują zdjęcia.</translation>
    </message>
    <message>
        <source>Measure the steps along the rails and between them, correct the positions, and align again.</source>
        <translation>Zmierz kroki wzdłuż szyn i pomiędzy nimi, popraw położenia i zorientuj ponownie.</translation>
    </message>
    <message>
        <source>The scale of the tags is wrong, or the height of the lens: by the floor that the photos show, the tags lie %1 times as far apart as the photos.</source>
        <translation>Skala położeń albo wysokość obiektywu jest błędna: według podłogi widocznej na zdjęciach podane miejsca są %1 razy dalej od siebie niż zdjęcia.</translation>
    </message>
    <message>
        <source>Measure the rail&apos;s steps and the lens&apos;s height, correct what is wrong, and align again.</source>
        <translation>Zmierz kroki szyny i wysokość obiektywu, popraw to, co błędne, i zorientuj ponownie.</translation>
    </message>
    <message>
        <source>How 1 photo is turned is not known: %1.</source>
        <translation>Nie wiadomo, jak obrócone jest 1 zdjęcie: %1.</translation>
    </message>
    <message>
        <source>How %1 photos are turned is not known: %2.</source>
        <translation>Nie wiadomo, jak obrócone jest %1 zdjęć: %2.</translation>
    </message>
    <message>
        <source>1 photo is left out, since the alignment found no pose that holds: %1.</source>
        <translation>Pominięto 1 zdjęcie, bo orientacja nie znalazła dla niego pewnej pozy: %1.</translation>
    </message>
    <message>
        <source>%1 photos are left out, since the alignment found no pose that holds: %2.</source>
        <translation>Pominięto %1 zdjęć, bo orientacja nie znalazła dla nich pewnej pozy: %2.</translation>
    </message>
    <message>
        <source>1 photo is left out, since nobody knows where it was taken: %1.</source>
        <translation>Pominięto 1 zdjęcie, bo nikt nie wie, gdzie je zrobiono: %1.</translation>
    </message>
    <message>
        <source>%1 photos are left out, since nobody knows where they were taken: %2.</source>
        <translation>Pominięto %1 zdjęć, bo nikt nie wie, gdzie je zrobiono: %2.</translation>
    </message>
    <message>
        <source>Aligning from the pictures alone finds that out.</source>
        <translation>Orientacja z samych zdjęć to ustali.</translation>
    </message>
    <message>
        <source>Look at what the alignment says of each, mend it, and align again.</source>
        <translation>Zobacz, co orientacja mówi o każdym, popraw to i zorientuj ponownie.</translation>
    </message>
    <message>
        <source>The alignment puts 1 photo nearer to another station than to the photo&apos;s own: %1.</source>
        <translation>Orientacja umieszcza 1 zdjęcie bliżej innej stacji niż własnej: %1.</translation>
    </message>
    <message>
        <source>The alignment puts %1 photos nearer to another station than to the photo&apos;s own: %2.</source>
        <translation>Orientacja umieszcza %1 zdjęć bliżej innej stacji niż własnej: %2.</translation>
    </message>
    <message>
        <source>The dataset has the solved places; retag the photos, and align again.</source>
        <translation>Zbiór danych ma rozwiązane położenia; przypisz zdjęcia na nowo i zorientuj ponownie.</translation>
    </message>
    <message>
        <source>1 photo has left the alignment, which was made with the earlier places; align again before you export.</source>
        <translation>1 zdjęcie opuściło orientację, którą wykonano z wcześniejszymi położeniami; zorientuj ponownie przed eksportem.</translation>
    </message>
    <message>
        <source>%1 photos have left the alignment, which was made with the earlier places; align again before you export.</source>
        <translation>%1 zdjęć opuściło orientację, którą wykonano z wcześniejszymi położeniami; zorientuj ponownie przed eksportem.</translation>
    </message>
    <message>
        <source>Its place contradicts how far the position tags put it from a neighbour: what both show alike may be of two places.</source>
        <translation>Jego położenie przeczy odległości od sąsiedniego zdjęcia, która wynika z podanych położeń: to, co oba pokazują podobnie, może pochodzić z dwóch miejsc.</translation>
    </message>
    <message>
        <source>The position tags are rough, so the places were solved from the pictures.</source>
        <translation>Podane położenia są niedokładne, więc miejsca obliczono ze zdjęć.</translation>
    </message>
    <message>
        <source>Only %1 of %2 photos hang together, too few to tell their place from another that looks like it.</source>
        <translation>Razem łączy się tylko %1 z %2 zdjęć, zbyt mało, by odróżnić ich miejsce od innego, które wygląda tak samo.</translation>
    </message>
    <message>
        <source>Take photos between them and the others.</source>
        <translation>Zrób zdjęcia między nimi a pozostałymi.</translation>
    </message>
    <message>
        <source>Comparing what photos show</source>
        <translation>Porównywanie tego, co pokazują zdjęcia</translation>
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
        <translation>Legenda planu</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CoverageView</name>
    <message>
        <source>%L1°</source>
        <translation>%L1°</translation>
    </message>
    <message>
        <source>Coverage of the room</source>
        <translation>Pokrycie pomieszczenia</translation>
    </message>
    <message>
        <source>%L1 px</source>
        <translation>%L1 px</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nie znaleziono</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 i więcej</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::DeskRemote</name>
    <message>
        <source>%1: the photo is being downloaded and checked.</source>
        <translation>%1: zdjęcie jest pobierane i sprawdzane.</translation>
    </message>
    <message>
        <source>Open a survey in the window.</source>
        <translation>Otwórz pomiar na komputerze.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) left</source>
        <translation>
            <numerusform>Zostało %n zdjęcie</numerusform>
            <numerusform>Zostały %n zdjęcia</numerusform>
            <numerusform>Zostało %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was done: the press came too late, or was for another station. Look at what is next, and press again.</source>
        <translation>Nic nie zrobiono: naciśnięcie przyszło za późno albo dotyczyło innego stanowiska. Sprawdź, co jest następne, i naciśnij ponownie.</translation>
    </message>
    <message>
        <source>Nothing was done: the camera is not ready for that.</source>
        <translation>Nic nie zrobiono: kamera nie jest na to gotowa.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::DriveView</name>
    <message>
        <source>What the robot&apos;s camera sees</source>
        <translation>Co widzi kamera robota</translation>
    </message>
    <message>
        <source>, coarse until it is decoded</source>
        <translation>, zgrubnie, dopóki się nie zdekoduje</translation>
    </message>
    <message>
        <source>, from the photo before until it is decoded</source>
        <translation>, z poprzedniego zdjęcia, dopóki się nie zdekoduje</translation>
    </message>
    <message>
        <source>Rendering...</source>
        <translation>Rysowanie...</translation>
    </message>
    <message>
        <source>Make a preview of the open survey, or open a dataset.</source>
        <translation>Zrób podgląd otwartego pomiaru albo otwórz zbiór danych.</translation>
    </message>
    <message>
        <source>scene model %1, sampling %2</source>
        <translation>model sceny: %1, próbkowanie: %2</translation>
    </message>
    <message>
        <source>outside of what was scanned</source>
        <translation>poza tym, co zeskanowano</translation>
    </message>
    <message>
        <source>no photo sees this place</source>
        <translation>żadne zdjęcie nie widzi tego miejsca</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>błąd nieznany</translation>
    </message>
    <message>
        <source>expected error %L1 px</source>
        <translation>oczekiwany błąd %L1 px</translation>
    </message>
    <message>
        <source>%1, %L2 cm away, %3, %L4 ms</source>
        <translation>%1, %L2 cm stąd, %3, %L4 ms</translation>
    </message>
    <message>
        <source>The robot&apos;s own picture: %1</source>
        <translation>Własny obraz robota: %1</translation>
    </message>
    <message>
        <source>expected error: 0 to %1 px and more</source>
        <translation>oczekiwany błąd: od 0 do %1 px i więcej</translation>
    </message>
    <message>
        <source>W A S D or the arrow keys drive, Q and E go sideways; drag to turn. Shift and a click put the object there.</source>
        <translation>W A S D lub strzałki jadą, Q i E przesuwają w bok; przeciąganie obraca. Shift i kliknięcie stawiają tam obiekt.</translation>
    </message>
    <message>
        <source>, %1 % of the size while it drives</source>
        <translation>, %1 % wielkości podczas jazdy</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Jazda</translation>
    </message>
    <message>
        <source>Lay the object, or take it away</source>
        <translation>Połóż obiekt lub go zabierz</translation>
    </message>
    <message>
        <source>Make the object larger or smaller</source>
        <translation>Powiększ lub zmniejsz obiekt</translation>
    </message>
    <message>
        <source>Turn the object</source>
        <translation>Obróć obiekt</translation>
    </message>
    <message>
        <source>Shift and the arrow keys</source>
        <translation>Shift i strzałki</translation>
    </message>
    <message>
        <source>Move the object</source>
        <translation>Przesuń obiekt</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Shift i kliknięcie</translation>
    </message>
    <message>
        <source>Stand the object on the surface there</source>
        <translation>Postaw tam obiekt na powierzchni</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportMode</name>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Make a dataset for simulators</source>
        <translation>Utwórz zbiór danych dla symulatorów</translation>
    </message>
    <message>
        <source>What and where</source>
        <translation>Co i dokąd</translation>
    </message>
    <message>
        <source>A folder that does not exist yet</source>
        <translation>Folder, którego jeszcze nie ma</translation>
    </message>
    <message>
        <source>Fastest views (photos grow by about 2 %)</source>
        <translation>Najszybsze widoki (zdjęcia rosną o około 2 %)</translation>
    </message>
    <message>
        <source>Smaller (0.6 %), views of new places take longer</source>
        <translation>Mniejszy (0,6 %), widoki nowych miejsc trwają dłużej</translation>
    </message>
    <message>
        <source>How far apart the marks are that let a part of a photo be decoded by itself</source>
        <translation>Jak daleko od siebie są znaczniki, dzięki którym da się zdekodować część zdjęcia</translation>
    </message>
    <message>
        <source>&amp;Optimised for</source>
        <translation>&amp;Zoptymalizowany pod</translation>
    </message>
    <message>
        <source>Open the folder &amp;when it is done</source>
        <translation>Po zakończeniu &amp;otwórz folder</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed eksportem</translation>
    </message>
    <message>
        <source>Chec&amp;k again</source>
        <translation>Sprawdź po&amp;nownie</translation>
    </message>
    <message>
        <source>Look again at what the dataset would have and lack</source>
        <translation>Sprawdź jeszcze raz, co zbiór danych będzie miał i czego mu zabraknie</translation>
    </message>
    <message>
        <source>Open the fol&amp;der</source>
        <translation>Otwórz fol&amp;der</translation>
    </message>
    <message>
        <source>Folder of the dataset</source>
        <translation>Folder zbioru danych</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2, in %3.</source>
        <translation>
            <numerusform>%1: %n zdjęcie, %2, w %3.</numerusform>
            <numerusform>%1: %n zdjęcia, %2, w %3.</numerusform>
            <numerusform>%1: %n zdjęć, %2, w %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>No survey is open.</source>
        <translation>Nie otwarto pomiaru.</translation>
    </message>
    <message>
        <source>Trying one photo...</source>
        <translation>Próba na jednym zdjęciu...</translation>
    </message>
    <message>
        <source>Not checked yet.</source>
        <translation>Jeszcze nie sprawdzono.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s), about %1 and %2; %3 are free.</source>
        <translation>
            <numerusform>%n zdjęcie, około %1 i %2; wolne: %3.</numerusform>
            <numerusform>%n zdjęcia, około %1 i %2; wolne: %3.</numerusform>
            <numerusform>%n zdjęć, około %1 i %2; wolne: %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>What the camera carries along covers %1 % of each photo. The dataset shows floor and walls there, as other photos see them.</source>
        <translation>To, co kamera wiezie ze sobą, zakrywa %1 % każdego zdjęcia. Zbiór danych pokazuje tam podłogę i ściany tak, jak widzą je inne zdjęcia.</translation>
    </message>
    <message>
        <source>Nothing is missing or doubtful.</source>
        <translation>Niczego nie brakuje i nic nie budzi wątpliwości.</translation>
    </message>
    <message>
        <source>Sphere (nothing more is computed)</source>
        <translation>Kula (nic więcej nie jest liczone)</translation>
    </message>
    <message>
        <source>Room: walls, floor, ceiling (a minute or two)</source>
        <translation>Pomieszczenie: ściany, podłoga, sufit (minuta lub dwie)</translation>
    </message>
    <message>
        <source>Depth of each pixel (some seconds a photo)</source>
        <translation>Głębia każdego piksela (kilka sekund na zdjęcie)</translation>
    </message>
    <message>
        <source>What views of places between photos can be computed with; cheaper ones come with it</source>
        <translation>Z czego można liczyć widoki z miejsc między zdjęciami; tańsze modele są dołączane</translation>
    </message>
    <message>
        <source>No program could open %1.</source>
        <translation>Żaden program nie mógł otworzyć %1.</translation>
    </message>
    <message>
        <source>Stop; nothing of the dataset is left then</source>
        <translation>Zatrzymaj; nic wtedy nie zostaje ze zbioru danych</translation>
    </message>
    <message>
        <source>The cheapest that holds a tolerance (all are tried and measured)</source>
        <translation>Najtańszy, który mieści się w tolerancji (wszystkie są sprawdzane i mierzone)</translation>
    </message>
    <message>
        <source>Eno&amp;ugh for</source>
        <translation>Wystarczający dl&amp;a</translation>
    </message>
    <message>
        <source>within</source>
        <translation>z dokładnością</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wybierz...</translation>
    </message>
    <message>
        <source>Fo&amp;lder</source>
        <translation>Fo&amp;lder</translation>
    </message>
    <message>
        <source>S&amp;cene model</source>
        <translation>Model &amp;sceny</translation>
    </message>
    <message>
        <source>Look at them in &amp;Review</source>
        <translation>Obe&amp;jrzyj je w Ocenie</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>Ekspor&amp;tuj</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) are doubtful or failed, and nobody has decided.</source>
        <translation>
            <numerusform>%n zdjęcie jest wątpliwe lub nieudane, a nikt nie zdecydował.</numerusform>
            <numerusform>%n zdjęcia są wątpliwe lub nieudane, a nikt nie zdecydował.</numerusform>
            <numerusform>%n zdjęć jest wątpliwych lub nieudanych, a nikt nie zdecydował.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>na %n zdjęciu</numerusform>
            <numerusform>na %n zdjęciach</numerusform>
            <numerusform>na %n zdjęciach</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n private region(s) %1 will be blurred.</source>
        <translation>
            <numerusform>%n obszar prywatny %1 zostanie zamazany.</numerusform>
            <numerusform>%n obszary prywatne %1 zostaną zamazane.</numerusform>
            <numerusform>%n obszarów prywatnych %1 zostanie zamazanych.</numerusform>
        </translation>
    </message>
    <message>
        <source>Measuring all that is tried comes on top of that.</source>
        <translation>Do tego dochodzi pomiar wszystkich prób.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ExportPresenter</name>
    <message>
        <source>Looking before the export</source>
        <translation>Sprawdzanie przed eksportem</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Eksport: %1</translation>
    </message>
    <message>
        <source>Stopped; nothing of the dataset is left.</source>
        <translation>Zatrzymano; ze zbioru danych nic nie zostało.</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n photo(s) to %1: %2.</source>
        <translation>
            <numerusform>Wyeksportowano %n zdjęcie do %1: %2.</numerusform>
            <numerusform>Wyeksportowano %n zdjęcia do %1: %2.</numerusform>
            <numerusform>Wyeksportowano %n zdjęć do %1: %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FaceSearchBar</name>
    <message>
        <source>Stop; the photos before are done, and the next search goes on behind them</source>
        <translation>Zatrzymaj; wcześniejsze zdjęcia są gotowe, a następne szukanie zacznie się za nimi</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Search %n photo(s) for faces</source>
        <translation>
            <numerusform>Szukaj &amp;twarzy na %n zdjęciu</numerusform>
            <numerusform>Szukaj &amp;twarzy na %n zdjęciach</numerusform>
            <numerusform>Szukaj &amp;twarzy na %n zdjęciach</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Search for faces again</source>
        <translation>Szukaj &amp;twarzy ponownie</translation>
    </message>
    <message>
        <source>Exports show faces blurred that the search finds. It misses small, covered and turned ones: look through the photos, too.</source>
        <translation>Twarze, które znajdzie szukanie, eksporty pokazują zamazane. Małe, zasłonięte i odwrócone umykają: przejrzyj zdjęcia także samodzielnie.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FindingWords</name>
    <message>
        <source>foreign, %L1 %</source>
        <translation>obce, %L1 %</translation>
    </message>
    <message>
        <source>foreign</source>
        <translation>obce</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>uszkodzone</translation>
    </message>
    <message>
        <source>other size</source>
        <translation>inny rozmiar</translation>
    </message>
    <message>
        <source>no sphere</source>
        <translation>nie sfera</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>inne ustawienia</translation>
    </message>
    <message>
        <source>too dark or bright</source>
        <translation>za ciemne lub jasne</translation>
    </message>
    <message>
        <source>other colours</source>
        <translation>inne kolory</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>nieostre</translation>
    </message>
    <message>
        <source>black area</source>
        <translation>czarny obszar</translation>
    </message>
    <message>
        <source>burnt area</source>
        <translation>prześwietlone</translation>
    </message>
    <message>
        <source>leaning</source>
        <translation>przechylone</translation>
    </message>
    <message>
        <source>turned</source>
        <translation>obrócone</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>gdzie indziej</translation>
    </message>
    <message>
        <source>not moved</source>
        <translation>nie przesunięto</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::FloorPicture</name>
    <message>
        <source>A PDF needs the program pdftoppm (poppler-utils); install it, or export the page as PNG or SVG.</source>
        <translation>PDF wymaga programu pdftoppm (poppler-utils); zainstaluj go albo zapisz stronę jako PNG lub SVG.</translation>
    </message>
    <message>
        <source>%1 is no PDF that can be drawn.</source>
        <translation>%1 nie jest plikiem PDF, który da się narysować.</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read.</source>
        <translation>%1 nie jest obrazem, który da się odczytać.</translation>
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
        <translation>95 ze 100 miejsc nie jest przesuniętych bardziej: w granicach tolerancji.</translation>
    </message>
    <message>
        <source>95 of 100 places are displaced by no more: beyond the tolerance.</source>
        <translation>95 ze 100 miejsc nie jest przesuniętych bardziej: poza tolerancją.</translation>
    </message>
    <message>
        <source>The pictures had too little in common to say.</source>
        <translation>Obrazy miały zbyt mało wspólnego, by to określić.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 z modelem: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2</source>
        <translation>
            <numerusform>%1: %n zdjęcie, %2</numerusform>
            <numerusform>%1: %n zdjęcia, %2</numerusform>
            <numerusform>%1: %n zdjęć, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyPanel</name>
    <message>
        <source>How dense?</source>
        <translation>Jak gęsto?</translation>
    </message>
    <message>
        <source>Robot&apos;s ca&amp;mera</source>
        <translation>Ka&amp;mera robota</translation>
    </message>
    <message>
        <source>T&amp;olerance</source>
        <translation>T&amp;olerancja</translation>
    </message>
    <message>
        <source>With &amp;depth (takes minutes)</source>
        <translation>Z &amp;głębią (trwa minuty)</translation>
    </message>
    <message>
        <source>Also estimate how far away every pixel is, which lets grids be much coarser</source>
        <translation>Szacuj też odległość każdego piksela, dzięki czemu siatka może być dużo rzadsza</translation>
    </message>
    <message>
        <source>Leave photos out, render what they would show from the rest, and compare</source>
        <translation>Pomiń zdjęcia, odtwórz z pozostałych to, co by pokazały, i porównaj</translation>
    </message>
    <message>
        <source>Steps that were studied</source>
        <translation>Zbadane kroki</translation>
    </message>
    <message>
        <source>Step to plan with</source>
        <translation>Krok do planowania</translation>
    </message>
    <message>
        <source>The coarsest step that holds the tolerance, for each scene model</source>
        <translation>Największy krok mieszczący się w tolerancji, dla każdego modelu sceny</translation>
    </message>
    <message>
        <source>&amp;Use this step</source>
        <translation>&amp;Użyj tego kroku</translation>
    </message>
    <message>
        <source>Plan with this step; where the plan is fixed, a new survey of the same room begins with it</source>
        <translation>Planuj z tym krokiem; gdy plan jest ustalony, zacznie się nim nowy pomiar tego samego pomieszczenia</translation>
    </message>
    <message>
        <source>Stop; what was found is kept for the next run</source>
        <translation>Zatrzymaj; co znaleziono, zostaje na następny raz</translation>
    </message>
    <message>
        <source>Stud&amp;y the grid</source>
        <translation>Zba&amp;daj siatkę</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::GridStudyPresenter</name>
    <message>
        <source>Open a survey with a small block of photos, 5 x 5 at the finest step that you would use.</source>
        <translation>Otwórz pomiar z małym blokiem zdjęć, 5 x 5 z najmniejszym krokiem, jaki wchodzi w grę.</translation>
    </message>
    <message numerus="yes">
        <source>This survey has %n photo(s). Take a block of 5 x 5 at the finest step that you would use (3 x 3 at least), and ask then.</source>
        <translation>
            <numerusform>Ten pomiar ma %n zdjęcie. Zrób blok 5 x 5 z najmniejszym krokiem, jaki wchodzi w grę (co najmniej 3 x 3), i wtedy zapytaj.</numerusform>
            <numerusform>Ten pomiar ma %n zdjęcia. Zrób blok 5 x 5 z najmniejszym krokiem, jaki wchodzi w grę (co najmniej 3 x 3), i wtedy zapytaj.</numerusform>
            <numerusform>Ten pomiar ma %n zdjęć. Zrób blok 5 x 5 z najmniejszym krokiem, jaki wchodzi w grę (co najmniej 3 x 3), i wtedy zapytaj.</numerusform>
        </translation>
    </message>
    <message>
        <source>Studying the grid of %1</source>
        <translation>Badanie siatki: %1</translation>
    </message>
    <message>
        <source>Stopped. What was found is kept: the next study goes on from there.</source>
        <translation>Zatrzymano. To, co znaleziono, zostaje: następne badanie ruszy od tego miejsca.</translation>
    </message>
    <message numerus="yes">
        <source>%1
Found in %2: %n photo(s), %L3 cm apart.</source>
        <translation>
            <numerusform>%1
Znaleziono w %2: %n zdjęcie co %L3 cm.</numerusform>
            <numerusform>%1
Znaleziono w %2: %n zdjęcia co %L3 cm.</numerusform>
            <numerusform>%1
Znaleziono w %2: %n zdjęć co %L3 cm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::HelpWindow</name>
    <message>
        <source>Guide</source>
        <translation>Przewodnik</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::LoginForm</name>
    <message>
        <source>&amp;Keep them in the system&apos;s keychain</source>
        <translation>&amp;Zachowaj je w systemowym pęku kluczy</translation>
    </message>
    <message>
        <source>The camera asks who is there</source>
        <translation>Kamera pyta, kto się łączy</translation>
    </message>
    <message>
        <source>The camera at %1 did not accept this user name and password.</source>
        <translation>Kamera pod adresem %1 nie przyjęła tej nazwy użytkownika i hasła.</translation>
    </message>
    <message>
        <source>The camera at %1 is in client mode, and wants a user name and a password.</source>
        <translation>Kamera pod adresem %1 działa w trybie klienta i żąda nazwy użytkownika i hasła.</translation>
    </message>
    <message>
        <source>As set in the camera; at first THETA and its serial number.</source>
        <translation>Jak ustawiono w kamerze; na początku THETA i numer seryjny.</translation>
    </message>
    <message>
        <source>As set in the camera; at first the digits of its serial number.</source>
        <translation>Jak ustawiono w kamerze; na początku cyfry numeru seryjnego.</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Połącz</translation>
    </message>
    <message>
        <source>&amp;User name:</source>
        <translation>Nazwa &amp;użytkownika:</translation>
    </message>
    <message>
        <source>&amp;Password:</source>
        <translation>&amp;Hasło:</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MainWindow</name>
    <message>
        <source>Modes</source>
        <translation>Tryby</translation>
    </message>
    <message>
        <source>Plan of the room</source>
        <translation>Plan pomieszczenia</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Zadania</translation>
    </message>
    <message>
        <source>Spherewalk</source>
        <translation>Spherewalk</translation>
    </message>
    <message>
        <source>Show what runs, and what has ended (Ctrl+T)</source>
        <translation>Pokaż, co trwa i co się zakończyło (Ctrl+T)</translation>
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
        <translation>Strona startowa (Ctrl+0)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Plik</translation>
    </message>
    <message>
        <source>&amp;New survey</source>
        <translation>&amp;Nowy pomiar</translation>
    </message>
    <message>
        <source>&amp;Open survey...</source>
        <translation>&amp;Otwórz pomiar...</translation>
    </message>
    <message>
        <source>&amp;Practice room</source>
        <translation>&amp;Pokój ćwiczebny</translation>
    </message>
    <message>
        <source>&amp;Close survey</source>
        <translation>&amp;Zamknij pomiar</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Za&amp;kończ</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edycja</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ponów</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Widok</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Pomo&amp;c</translation>
    </message>
    <message>
        <source>&amp;About Spherewalk</source>
        <translation>&amp;O programie Spherewalk</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Pełny ekran</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Wygląd</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Jak &amp;pulpit</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Jasny</translation>
    </message>
    <message>
        <source>Da&amp;rk</source>
        <translation>&amp;Ciemny</translation>
    </message>
    <message>
        <source>%1 - Spherewalk</source>
        <translation>%1 - Spherewalk</translation>
    </message>
    <message>
        <source>%1 of %2 stations have a photo</source>
        <translation>%1 z %2 stanowisk ma zdjęcie</translation>
    </message>
    <message>
        <source>%1; another program writes</source>
        <translation>%1; zapisuje inny program</translation>
    </message>
    <message numerus="yes">
        <source>%n task(s)</source>
        <translation>
            <numerusform>%n zadanie</numerusform>
            <numerusform>%n zadania</numerusform>
            <numerusform>%n zadań</numerusform>
        </translation>
    </message>
    <message>
        <source>Open survey</source>
        <translation>Otwórz pomiar</translation>
    </message>
    <message>
        <source>practice room</source>
        <translation>pokój ćwiczebny</translation>
    </message>
    <message>
        <source>Spherewalk %1, free software under the GNU General Public License, version 3 or later.</source>
        <translation>Spherewalk %1, wolne oprogramowanie na licencji GNU GPL w wersji 3 lub późniejszej.</translation>
    </message>
    <message>
        <source>&amp;Import photos...</source>
        <translation>&amp;Importuj zdjęcia...</translation>
    </message>
    <message>
        <source>&amp;Guide to this page</source>
        <translation>Przewodnik po tej &amp;stronie</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Klawisze</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Klawisz</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Co robi</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Wszędzie</translation>
    </message>
    <message>
        <source>Positions of the photos</source>
        <translation>Położenia zdjęć</translation>
    </message>
    <message>
        <source>Positions (*.csv)</source>
        <translation>Położenia (*.csv)</translation>
    </message>
    <message>
        <source>Folder of the photos</source>
        <translation>Folder ze zdjęciami</translation>
    </message>
    <message>
        <source>Importing photos</source>
        <translation>Importowanie zdjęć</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Język</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Jak &amp;system</translation>
    </message>
    <message>
        <source>The language changes when the program is started the next time.</source>
        <translation>Język zmieni się przy następnym uruchomieniu programu.</translation>
    </message>
    <message>
        <source>Open a survey first; the photos become part of it.</source>
        <translation>Najpierw otwórz pomiar; zdjęcia staną się jego częścią.</translation>
    </message>
    <message>
        <source>&amp;Tour in five steps</source>
        <translation>&amp;Zwiedzanie w pięciu krokach</translation>
    </message>
    <message>
        <source>&amp;Recent surveys</source>
        <translation>Os&amp;tatnie pomiary</translation>
    </message>
    <message>
        <source>Import photos &amp;without positions...</source>
        <translation>Importuj zdjęcia &amp;bez pozycji...</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) imported, %1 were there already.</source>
        <translation>
            <numerusform>Zaimportowano %n zdjęcie, %1 już było.</numerusform>
            <numerusform>Zaimportowano %n zdjęcia, %1 już było.</numerusform>
            <numerusform>Zaimportowano %n zdjęć, %1 już było.</numerusform>
        </translation>
    </message>
    <message>
        <source>Align solves where they were taken.</source>
        <translation>Gdzie je zrobiono, obliczy Orientacja.</translation>
    </message>
    <message>
        <source>Check them in Review.</source>
        <translation>Sprawdź je w Ocenie.</translation>
    </message>
    <message>
        <source>New survey by &amp;hand</source>
        <translation>Nowy pomiar z &amp;ręki</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>obchód</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MeasurePanel</name>
    <message>
        <source>How right its views are</source>
        <translation>Jak wierne są widoki</translation>
    </message>
    <message>
        <source>Open &amp;report</source>
        <translation>Otwórz &amp;raport</translation>
    </message>
    <message>
        <source>The page with error maps and trade-offs; the same as PDF lies beside it</source>
        <translation>Strona z mapami błędów i kosztami; obok leży to samo jako PDF</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancja</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Z&amp;mierz</translation>
    </message>
    <message>
        <source>Leave photos out, render what they would show from the rest, and compare</source>
        <translation>Pomiń zdjęcia, odtwórz z pozostałych to, co by pokazały, i porównaj</translation>
    </message>
    <message>
        <source>Robot&apos;s camera</source>
        <translation>Kamera robota</translation>
    </message>
    <message>
        <source>Export a dataset first, or name the folder of one that is there.</source>
        <translation>Najpierw wyeksportuj zbiór danych albo podaj folder istniejącego.</translation>
    </message>
    <message>
        <source>Stop; what was found is kept for the next run</source>
        <translation>Zatrzymaj; co znaleziono, zostaje na następny raz</translation>
    </message>
    <message>
        <source>Stored: views whose choice is left to the dataset are made so.</source>
        <translation>Zapisano: widoki, które zostawiają wybór zbiorowi danych, są tak liczone.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::MeasurePresenter</name>
    <message>
        <source>Measuring %1</source>
        <translation>Mierzenie: %1</translation>
    </message>
    <message>
        <source>Stopped. What was found is kept: measuring again goes on from there.</source>
        <translation>Zatrzymano. To, co znaleziono, zostaje: ponowne mierzenie ruszy od tego miejsca.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::NewSurveyForm</name>
    <message>
        <source>New survey</source>
        <translation>Nowy pomiar</translation>
    </message>
    <message>
        <source>&amp;Create survey</source>
        <translation>Utwó&amp;rz pomiar</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nazwa</translation>
    </message>
    <message>
        <source>What the room is called; the survey&apos;s folder gets this name.</source>
        <translation>Jak nazywa się pomieszczenie; tę nazwę dostanie folder pomiaru.</translation>
    </message>
    <message>
        <source>Kept &amp;in</source>
        <translation>M&amp;iejsce</translation>
    </message>
    <message>
        <source>The folder in which the survey&apos;s folder is made.</source>
        <translation>Folder, w którym powstanie folder pomiaru.</translation>
    </message>
    <message>
        <source>room</source>
        <translation>pokój</translation>
    </message>
    <message>
        <source>room %1</source>
        <translation>pokój %1</translation>
    </message>
    <message>
        <source>There is a survey of this name already.</source>
        <translation>Jest już pomiar o tej nazwie.</translation>
    </message>
    <message>
        <source>Makes the survey on the disk.</source>
        <translation>Tworzy pomiar na dysku.</translation>
    </message>
    <message>
        <source>Where surveys are kept</source>
        <translation>Gdzie są pomiary</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ObjectFields</name>
    <message>
        <source>Object in the view</source>
        <translation>Obiekt w widoku</translation>
    </message>
    <message>
        <source>An object as a simulator would render it. With Shift, click in the view to stand it on the surface there, or on the plan. O lays it or takes it away, + and - change its size, comma and period turn it, and the arrow keys with Shift move it.</source>
        <translation>Obiekt taki, jaki narysowałby symulator. Z klawiszem Shift kliknij w widoku, aby postawić go tam na powierzchni, lub na planie. O kładzie go lub zabiera, + i - zmieniają wielkość, przecinek i kropka obracają, a strzałki z Shift przesuwają.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nic</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kula</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Sześcian</translation>
    </message>
    <message>
        <source>Mesh (OBJ file)...</source>
        <translation>Siatka (plik OBJ)...</translation>
    </message>
    <message>
        <source>Size of the object</source>
        <translation>Wielkość obiektu</translation>
    </message>
    <message>
        <source>Its longest side</source>
        <translation>Jego najdłuższy bok</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>O&amp;bject</source>
        <translation>Obie&amp;kt</translation>
    </message>
    <message>
        <source>Mesh with z up, in metres</source>
        <translation>Siatka z osią z w górę, w metrach</translation>
    </message>
    <message>
        <source>Meshes (*.obj)</source>
        <translation>Siatki (*.obj)</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ObjectStage</name>
    <message>
        <source>Reading %1</source>
        <translation>Czytanie %1</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PagePanel</name>
    <message>
        <source>A page to share</source>
        <translation>Strona do udostępnienia</translation>
    </message>
    <message>
        <source>Plan, panoramas to walk through, distances, and the notes of the review, in a folder that any browser opens. Nothing needs to be installed.</source>
        <translation>Plan, panoramy do przechodzenia, odległości i uwagi z oceny w folderze, który otworzy każda przeglądarka. Niczego nie trzeba instalować.</translation>
    </message>
    <message>
        <source>Write the page</source>
        <translation>Zapisz stronę</translation>
    </message>
    <message>
        <source>Stop; nothing is written then</source>
        <translation>Zatrzymaj; nic wtedy nie zostanie zapisane</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Obejrzyj ją</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PagePresenter</name>
    <message>
        <source>Writing the page of %1</source>
        <translation>Zapisywanie strony: %1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), %2. Distances can be measured in %3 of them. Share the whole folder.</source>
        <translation>
            <numerusform>%1: %n zdjęcie, %2. Odległości można mierzyć na tylu z nich: %3. Udostępnij cały folder.</numerusform>
            <numerusform>%1: %n zdjęcia, %2. Odległości można mierzyć na tylu z nich: %3. Udostępnij cały folder.</numerusform>
            <numerusform>%1: %n zdjęć, %2. Odległości można mierzyć na tylu z nich: %3. Udostępnij cały folder.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Zatrzymano; nic nie zapisano.</translation>
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
        <translation>Panorama: %1. Przeciągaj albo używaj klawiszy strzałek.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Plan of the room with the photos</source>
        <translation>Plan pomieszczenia ze zdjęciami</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Zdjęcie</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Stanowisko</translation>
    </message>
    <message>
        <source>On the floor</source>
        <translation>Na podłodze</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Zmierz</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Odległości</translation>
    </message>
    <message>
        <source>± is one standard deviation, of the depth, of the click, and of the scale of the whole room as far as it is known.</source>
        <translation>± to jedno odchylenie standardowe głębi, kliknięcia i skali całego pomieszczenia, o ile jest znana.</translation>
    </message>
    <message>
        <source>Remove the last one</source>
        <translation>Usuń ostatnią</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Walk ahead</source>
        <translation>Idź naprzód</translation>
    </message>
    <message>
        <source>Walk back</source>
        <translation>Idź wstecz</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Przybliż</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Oddal</translation>
    </message>
    <message>
        <source>This page needs JavaScript, which is switched off in this browser.</source>
        <translation>Ta strona wymaga JavaScriptu, a jest on w tej przeglądarce wyłączony.</translation>
    </message>
    <message>
        <source>This browser shows no 3D graphics (WebGL), so there are no panoramas. Plan and notes work.</source>
        <translation>Ta przeglądarka nie pokazuje grafiki 3D (WebGL), więc nie ma panoram. Plan i uwagi działają.</translation>
    </message>
    <message>
        <source>The file %1 could not be read. The folder must be copied whole.</source>
        <translation>Nie udało się odczytać pliku %1. Folder trzeba kopiować w całości.</translation>
    </message>
    <message>
        <source>1 photo</source>
        <translation>1 zdjęcie</translation>
    </message>
    <message>
        <source>%1 photos</source>
        <translation>Zdjęcia: %1</translation>
    </message>
    <message>
        <source>made by %1 on %2</source>
        <translation>zrobione przez %1 dnia %2</translation>
    </message>
    <message>
        <source>All lengths are known to %1 %.</source>
        <translation>Wszystkie długości są znane z dokładnością do %1 %.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>dobre</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>wątpliwe</translation>
    </message>
    <message>
        <source>failed the checks</source>
        <translation>nie przeszło kontroli</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nieocenione</translation>
    </message>
    <message>
        <source>accepted by a person</source>
        <translation>przyjęte przez człowieka</translation>
    </message>
    <message>
        <source>no photo</source>
        <translation>brak zdjęcia</translation>
    </message>
    <message>
        <source>photo rejected</source>
        <translation>zdjęcie odrzucone</translation>
    </message>
    <message>
        <source>photo not placed: its alignment failed</source>
        <translation>zdjęcie bez miejsca: jego orientacja się nie udała</translation>
    </message>
    <message>
        <source>This page was made of a dataset, which has no verdicts and no notes.</source>
        <translation>Ta strona powstała ze zbioru danych, który nie ma ocen ani uwag.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Uwaga: %1</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high</source>
        <translation>x %1 m, y %2 m, wysokość %3 m</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3 m high, ± %4 m</source>
        <translation>x %1 m, y %2 m, wysokość %3 m, ± %4 m</translation>
    </message>
    <message>
        <source>Views that replace this photo are off by %1 pixels.</source>
        <translation>Widoki, które zastępują to zdjęcie, odbiegają o %1 pikseli.</translation>
    </message>
    <message>
        <source>The heading of this photo is not known.</source>
        <translation>Kierunek tego zdjęcia nie jest znany.</translation>
    </message>
    <message>
        <source>This photo has no depth: nothing can be measured in it.</source>
        <translation>To zdjęcie nie ma głębi: niczego nie można na nim zmierzyć.</translation>
    </message>
    <message>
        <source>The depth there was not measured.</source>
        <translation>Głębi w tym miejscu nie zmierzono.</translation>
    </message>
    <message>
        <source>Choose a point, with a click or with Enter for the middle.</source>
        <translation>Wybierz punkt: kliknięciem albo klawiszem Enter na środku.</translation>
    </message>
    <message>
        <source>Choose the other end.</source>
        <translation>Wybierz drugi koniec.</translation>
    </message>
    <message>
        <source>There is no photo to walk to in this direction.</source>
        <translation>W tym kierunku nie ma zdjęcia, do którego można pójść.</translation>
    </message>
    <message>
        <source>%1 m ± %2 m</source>
        <translation>%1 m ± %2 m</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>obrót</translation>
    </message>
    <message>
        <source>walk ahead and back</source>
        <translation>idź naprzód i wstecz</translation>
    </message>
    <message>
        <source>look up and down</source>
        <translation>patrz w górę i w dół</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>powiększenie</translation>
    </message>
    <message>
        <source>look level</source>
        <translation>patrz poziomo</translation>
    </message>
    <message>
        <source>measure a distance</source>
        <translation>zmierz odległość</translation>
    </message>
    <message>
        <source>while measuring: take the middle of the picture</source>
        <translation>przy mierzeniu: weź środek obrazu</translation>
    </message>
    <message>
        <source>while measuring: take back the last point</source>
        <translation>przy mierzeniu: cofnij ostatni punkt</translation>
    </message>
    <message>
        <source>end measuring</source>
        <translation>zakończ mierzenie</translation>
    </message>
    <message>
        <source>this list</source>
        <translation>ta lista</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Pokrycie</translation>
    </message>
    <message>
        <source>Floor within reach of a photo: half the diagonal of the grid&apos;s cell</source>
        <translation>Podłoga w zasięgu zdjęcia: połowa przekątnej oczka siatki</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>pokryte</translation>
    </message>
    <message>
        <source>Error of views</source>
        <translation>Błąd widoków</translation>
    </message>
    <message>
        <source>95th percentile of displacement where the photo was left out</source>
        <translation>95. percentyl przesunięcia tam, gdzie zdjęcie pominięto</translation>
    </message>
    <message>
        <source>Uncertainty of the heading</source>
        <translation>Niepewność kierunku</translation>
    </message>
    <message>
        <source>Standard deviation of each photo&apos;s heading, in pixels of a camera of 640 pixels and 57 degrees</source>
        <translation>Odchylenie standardowe kierunku każdego zdjęcia, w pikselach kamery o 640 pikselach i 57 stopniach</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 px, the tolerance</source>
        <translation>%1 px, tolerancja</translation>
    </message>
    <message>
        <source>%1 px and less</source>
        <translation>%1 px i mniej</translation>
    </message>
    <message>
        <source>%1 px and more</source>
        <translation>%1 px i więcej</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>niezmierzone</translation>
    </message>
    <message>
        <source>Foretold error of views</source>
        <translation>Przewidywany błąd widoków</translation>
    </message>
    <message>
        <source>Median displacement that the photos foretell for views from there, at their own height, in pixels of a camera of 640 pixels and 57 degrees</source>
        <translation>Mediana przesunięcia, jakie zdjęcia przewidują dla widoków stamtąd, na ich własnej wysokości, w pikselach kamery o 640 pikselach i 57 stopniach</translation>
    </message>
    <message>
        <source>nothing is known</source>
        <translation>nic nie wiadomo</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PanoramaPresenter</name>
    <message>
        <source>No photo is chosen.</source>
        <translation>Nie wybrano zdjęcia.</translation>
    </message>
    <message>
        <source>Decoding %1...</source>
        <translation>Dekodowanie %1...</translation>
    </message>
    <message>
        <source>as seen from here, by measured depth</source>
        <translation>widziane stąd, według zmierzonej głębi</translation>
    </message>
    <message>
        <source>as seen from here, by the drawn walls</source>
        <translation>widziane stąd, według narysowanych ścian</translation>
    </message>
    <message>
        <source>as seen from here, roughly</source>
        <translation>widziane stąd, w przybliżeniu</translation>
    </message>
    <message>
        <source>turned as the first</source>
        <translation>obrócone jak pierwsze</translation>
    </message>
    <message>
        <source>Moving %1 to here...</source>
        <translation>Przenoszenie tutaj: %1...</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PanoramaView</name>
    <message>
        <source>Photo to look around in</source>
        <translation>Zdjęcie, w którym można się rozejrzeć</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to look around; wheel, + and - change the field of view; 0 looks level</source>
        <translation>Przeciągaj albo używaj strzałek, by się rozglądać; kółko, + i - zmieniają pole widzenia; 0 patrzy poziomo</translation>
    </message>
    <message>
        <source>A: %1</source>
        <translation>A: %1</translation>
    </message>
    <message>
        <source>heading %1°, %2° up, %3° wide</source>
        <translation>kierunek %1°, %2° w górę, szerokość %3°</translation>
    </message>
    <message>
        <source>B: %1
%2</source>
        <translation>B: %1
%2</translation>
    </message>
    <message>
        <source>Not aligned yet: the second photo is turned by what both show, roughly.</source>
        <translation>Orientacja nie jest jeszcze wyznaczona: drugie zdjęcie obrócono w przybliżeniu według tego, co pokazują oba.</translation>
    </message>
    <message>
        <source>A box is being put around what exports shall show blurred.</source>
        <translation>Ramka jest zakładana wokół tego, co eksporty mają pokazać zamazane.</translation>
    </message>
    <message>
        <source>Private region %1 of %2, found by the search</source>
        <translation>Obszar prywatny %1 z %2, znaleziony przez szukanie</translation>
    </message>
    <message>
        <source>Private region %1 of %2, marked by hand</source>
        <translation>Obszar prywatny %1 z %2, zaznaczony ręcznie</translation>
    </message>
    <message>
        <source>Drag a box. Or move this one: arrow keys move it, and with Shift they size it. Return hides what is in it, Escape leaves.</source>
        <translation>Przeciągnij ramkę. Albo użyj tej: strzałki przesuwają ją, a z Shift zmieniają jej rozmiar. Enter ukrywa to, co w niej jest, Esc kończy.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PathPlayer</name>
    <message>
        <source>Pla&amp;y</source>
        <translation>&amp;Odtwórz</translation>
    </message>
    <message>
        <source>Drive the recorded path again, as fast as it was driven</source>
        <translation>Przejedź nagraną drogę jeszcze raz, tak szybko jak wtedy</translation>
    </message>
    <message>
        <source>Place on the recorded path</source>
        <translation>Miejsce na nagranej drodze</translation>
    </message>
    <message>
        <source>Go to any pose of the recorded path</source>
        <translation>Przejdź do dowolnego miejsca nagranej drogi</translation>
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
        <translation>Nie można przyjmować połączeń pod adresem %1: %2.</translation>
    </message>
    <message>
        <source>This is not the address that the window shows.</source>
        <translation>To nie jest adres, który pokazuje komputer.</translation>
    </message>
    <message>
        <source>This device is not paired.</source>
        <translation>To urządzenie nie jest sparowane.</translation>
    </message>
    <message>
        <source>The code is wrong.</source>
        <translation>Kod jest błędny.</translation>
    </message>
    <message>
        <source>There were too many wrong codes. Make a new code in the window.</source>
        <translation>Było zbyt wiele błędnych kodów. Utwórz nowy kod na komputerze.</translation>
    </message>
    <message>
        <source>Another device is the remote. Let go of it in the window first.</source>
        <translation>Pilotem jest inne urządzenie. Najpierw odłącz je na komputerze.</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of the language of these words</comment>
        <translation>pl</translation>
    </message>
    <message>
        <source>Spherewalk: remote</source>
        <translation>Spherewalk: pilot</translation>
    </message>
    <message>
        <source>Pair this device</source>
        <translation>Sparuj to urządzenie</translation>
    </message>
    <message>
        <source>Type the code that the window on the computer shows.</source>
        <translation>Wpisz kod, który pokazuje komputer.</translation>
    </message>
    <message>
        <source>Code of six digits</source>
        <translation>Kod z sześciu cyfr</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Sparuj</translation>
    </message>
    <message>
        <source>Last photo</source>
        <translation>Ostatnie zdjęcie</translation>
    </message>
    <message>
        <source>No photo yet.</source>
        <translation>Nie ma jeszcze zdjęcia.</translation>
    </message>
    <message>
        <source>Take it again</source>
        <translation>Powtórz to zdjęcie</translation>
    </message>
    <message>
        <source>No connection to the computer. Trying again...</source>
        <translation>Brak połączenia z komputerem. Kolejna próba...</translation>
    </message>
    <message>
        <source>The press did not reach the computer. Press again.</source>
        <translation>Naciśnięcie nie dotarło do komputera. Naciśnij ponownie.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>dobre</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhotoMover</name>
    <message>
        <source>The two photos cannot be compared before they are aligned: nothing tells how one is turned against the other.</source>
        <translation>Tych dwóch zdjęć nie można porównać przed wyznaczeniem orientacji: nic nie mówi, jak jedno jest obrócone względem drugiego.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PhotoReviewer</name>
    <message numerus="yes">
        <source>Accept %n photo(s)</source>
        <translation>
            <numerusform>Przyjęcie %n zdjęcia</numerusform>
            <numerusform>Przyjęcie %n zdjęć</numerusform>
            <numerusform>Przyjęcie %n zdjęć</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reject %n photo(s)</source>
        <translation>
            <numerusform>Odrzucenie %n zdjęcia</numerusform>
            <numerusform>Odrzucenie %n zdjęć</numerusform>
            <numerusform>Odrzucenie %n zdjęć</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reopen %n photo(s)</source>
        <translation>
            <numerusform>Ponowne otwarcie %n zdjęcia</numerusform>
            <numerusform>Ponowne otwarcie %n zdjęć</numerusform>
            <numerusform>Ponowne otwarcie %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>Note on a photo</source>
        <translation>Notatka do zdjęcia</translation>
    </message>
    <message>
        <source>Hide a region</source>
        <translation>Ukryj obszar</translation>
    </message>
    <message>
        <source>Remove a region</source>
        <translation>Usuń obszar</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlacePanel</name>
    <message>
        <source>The place for other programs</source>
        <translation>Miejsce dla innych programów</translation>
    </message>
    <message>
        <source>Points (PLY)</source>
        <translation>Punkty (PLY)</translation>
    </message>
    <message>
        <source>Every vertex with colour, normal, and how many photos show it</source>
        <translation>Każdy punkt z kolorem, normalną i liczbą zdjęć, które go pokazują</translation>
    </message>
    <message>
        <source>Mesh (glTF)</source>
        <translation>Siatka (glTF)</translation>
    </message>
    <message>
        <source>One file that viewers and game engines open</source>
        <translation>Jeden plik, który otwierają przeglądarki i silniki gier</translation>
    </message>
    <message>
        <source>Mesh (OBJ)</source>
        <translation>Siatka (OBJ)</translation>
    </message>
    <message>
        <source>The same as text</source>
        <translation>To samo jako tekst</translation>
    </message>
    <message>
        <source>Map for robots</source>
        <translation>Mapa dla robotów</translation>
    </message>
    <message>
        <source>Where a robot can drive, as Nav2 and map_server read it</source>
        <translation>Gdzie robot może jechać, tak jak czytają to Nav2 i map_server</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Zapisz</translation>
    </message>
    <message>
        <source>Stop; nothing is written then</source>
        <translation>Zatrzymaj; nic wtedy nie zostanie zapisane</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Otwórz jego folder</translation>
    </message>
    <message>
        <source>A dataset with the depths of two photos or more is needed: export one with depth as its scene model.</source>
        <translation>Potrzebny jest zbiór danych z głębią co najmniej dwóch zdjęć: wyeksportuj go z głębią jako modelem sceny.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlacePresenter</name>
    <message>
        <source>Writing the place of %1</source>
        <translation>Zapisywanie miejsca z %1</translation>
    </message>
    <message>
        <source>%1: %L2 m² of surfaces. From the photos there is a surface in %L3 % of all directions; the rest are holes. Two photos or more show %L4 % of it.</source>
        <translation>%1: %L2 m² powierzchni. Ze zdjęć widać powierzchnię w %L3 % wszystkich kierunków; reszta to dziury. Co najmniej dwa zdjęcia pokazują %L4 % z niej.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Zatrzymano; nic nie zapisano.</translation>
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
        <translation>Plan pomieszczenia</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanEditor</name>
    <message>
        <source>Move corner</source>
        <translation>Przesunięcie narożnika</translation>
    </message>
    <message>
        <source>Move outline</source>
        <translation>Przesunięcie obrysu</translation>
    </message>
    <message>
        <source>Move obstacle</source>
        <translation>Przesunięcie przeszkody</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Dodanie narożnika</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Usunięcie narożnika</translation>
    </message>
    <message>
        <source>Remove obstacle</source>
        <translation>Usunięcie przeszkody</translation>
    </message>
    <message>
        <source>Draw outline</source>
        <translation>Narysowanie obrysu</translation>
    </message>
    <message>
        <source>Add obstacle</source>
        <translation>Dodanie przeszkody</translation>
    </message>
    <message>
        <source>Remove the room&apos;s name</source>
        <translation>Usuń nazwę pomieszczenia</translation>
    </message>
    <message>
        <source>Name room</source>
        <translation>Nazwij pomieszczenie</translation>
    </message>
    <message>
        <source>Lay rail</source>
        <translation>Ułóż szynę</translation>
    </message>
    <message>
        <source>Split rail</source>
        <translation>Podziel szynę</translation>
    </message>
    <message>
        <source>Remove rail</source>
        <translation>Usuń szynę</translation>
    </message>
    <message>
        <source>Remove stop</source>
        <translation>Usuń postój</translation>
    </message>
    <message>
        <source>Lock rail</source>
        <translation>Zablokuj szynę</translation>
    </message>
    <message>
        <source>Unlock rail</source>
        <translation>Odblokuj szynę</translation>
    </message>
    <message>
        <source>Lay rails anew</source>
        <translation>Ułóż szyny na nowo</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanEditorView</name>
    <message>
        <source>%L1 m² not covered</source>
        <translation>%L1 m² bez pokrycia</translation>
    </message>
    <message>
        <source>%L1 m</source>
        <translation>%L1 m</translation>
    </message>
    <message>
        <source>%1 m, then Return</source>
        <translation>%1 m, potem Enter</translation>
    </message>
    <message>
        <source>Drawing of the room</source>
        <translation>Rysunek pomieszczenia</translation>
    </message>
    <message>
        <source>Click corner after corner, or type a wall&apos;s length and press Return. Close on the first corner, or with a double click.</source>
        <translation>Klikaj narożnik po narożniku albo wpisz długość ściany i naciśnij Enter. Zamknij na pierwszym narożniku lub podwójnym kliknięciem.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know.</source>
        <translation>Przeciągnij wzdłuż czegoś o znanej długości.</translation>
    </message>
    <message>
        <source>Drag a corner on the picture to the corner where it belongs.</source>
        <translation>Przeciągnij narożnik obrazu do narożnika, do którego należy.</translation>
    </message>
    <message>
        <source>Drag a second corner to its place: the picture turns and scales around the first.</source>
        <translation>Przeciągnij drugi narożnik na jego miejsce: obraz obróci się i przeskaluje wokół pierwszego.</translation>
    </message>
    <message>
        <source>Click into a room to name it, or on a name to change it.</source>
        <translation>Kliknij w pomieszczenie, aby je nazwać, albo w nazwę, aby ją zmienić.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanMode</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Rysowanie</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Przesuń</translation>
    </message>
    <message>
        <source>Move corners and obstacles</source>
        <translation>Przesuwaj narożniki i przeszkody</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Obrys</translation>
    </message>
    <message>
        <source>Draw the outline of the room anew</source>
        <translation>Narysuj obrys pomieszczenia od nowa</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Przeszkoda</translation>
    </message>
    <message>
        <source>Draw something that stands on the floor</source>
        <translation>Narysuj coś, co stoi na podłodze</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Draw a known length on the picture</source>
        <translation>Zaznacz znaną długość na obrazie</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponów</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Całość</translation>
    </message>
    <message>
        <source>Bring the whole room into sight (0)</source>
        <translation>Pokaż całe pomieszczenie (0)</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Lay a floor plan under the drawing, or take it away</source>
        <translation>Podłóż rzut pod rysunek albo go usuń</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Arkusz</translation>
    </message>
    <message>
        <source>Write the marking-out sheet: the plan to scale with tape distances, as PDF</source>
        <translation>Zapisz arkusz wytyczania: plan w skali z odległościami do taśmy, jako PDF</translation>
    </message>
    <message>
        <source>The line is this long:</source>
        <translation>Ta linia ma długość:</translation>
    </message>
    <message>
        <source>Length of the line</source>
        <translation>Długość linii</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Ustaw skalę</translation>
    </message>
    <message>
        <source>Stored.</source>
        <translation>Zapisano.</translation>
    </message>
    <message>
        <source>Storing...</source>
        <translation>Zapisywanie...</translation>
    </message>
    <message>
        <source>Floor plan</source>
        <translation>Rzut</translation>
    </message>
    <message>
        <source>There is no picture to scale; choose one first.</source>
        <translation>Nie ma obrazu do wyskalowania; najpierw go wybierz.</translation>
    </message>
    <message>
        <source>Marking-out sheet</source>
        <translation>Arkusz wytyczania</translation>
    </message>
    <message>
        <source>marking-out.pdf</source>
        <translation>wytyczanie.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>Zapisano %1.</translation>
    </message>
    <message>
        <source>The plan is fixed</source>
        <translation>Plan jest ustalony</translation>
    </message>
    <message>
        <source>Photos stand on this plan, or another program writes the survey.</source>
        <translation>Na tym planie są już zdjęcia albo pomiar zapisuje inny program.</translation>
    </message>
    <message>
        <source>New survey with this room</source>
        <translation>Nowy pomiar z tym pomieszczeniem</translation>
    </message>
    <message>
        <source>Draw the room and lay out where photos are to be taken</source>
        <translation>Narysuj pomieszczenie i rozplanuj miejsca zdjęć</translation>
    </message>
    <message>
        <source>Use step</source>
        <translation>Użycie kroku</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ułóż</translation>
    </message>
    <message>
        <source>Move, turn and scale the picture by two of its corners</source>
        <translation>Przesuń, obróć i przeskaluj obraz według dwóch jego narożników</translation>
    </message>
    <message>
        <source>Pictures and maps (*.png *.jpg *.jpeg *.svg *.bmp *.pgm *.pdf *.yaml *.yml)</source>
        <translation>Obrazy i mapy (*.png *.jpg *.jpeg *.svg *.bmp *.pgm *.pdf *.yaml *.yml)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Name the rooms of a flat</source>
        <translation>Nazwij pomieszczenia mieszkania</translation>
    </message>
    <message>
        <source>Name of the room</source>
        <translation>Nazwa pomieszczenia</translation>
    </message>
    <message>
        <source>What is this room called?</source>
        <translation>Jak nazywa się to pomieszczenie?</translation>
    </message>
    <message>
        <source>Rails</source>
        <translation>Szyny</translation>
    </message>
    <message>
        <source>Move, turn, lengthen, add and remove rails by hand</source>
        <translation>Ręcznie przesuwaj, obracaj, wydłużaj, dodawaj i usuwaj szyny</translation>
    </message>
    <message>
        <source>Remove the selected corner, obstacle, stop or rail (Delete)</source>
        <translation>Usuń wybrany narożnik, przeszkodę, postój lub szynę (Delete)</translation>
    </message>
    <message>
        <source>Nobody has drawn this room: the rectangle is only to begin with. Draw it as it is; without that, an export with depth finds it in the photos.</source>
        <translation>Tego pomieszczenia nikt nie narysował: prostokąt to tylko początek. Narysuj je takie, jakie jest; bez tego eksport z głębią znajdzie je na zdjęciach.</translation>
    </message>
    <message>
        <source>Stored. Align keeps the room as you drew it.</source>
        <translation>Zapisano. Orientacja zachowa pomieszczenie tak, jak je narysowano.</translation>
    </message>
    <message>
        <source>The room is what the photos show. If you draw it as it is, Align keeps it so.</source>
        <translation>Pomieszczenie jest takie, jak widać na zdjęciach. Narysowane tak, jak jest, zostanie takie przy orientacji.</translation>
    </message>
    <message>
        <source>Nobody knows where the photos stand. Align finds that out from the pictures alone; then their room can be drawn.</source>
        <translation>Nie wiadomo, gdzie stoją zdjęcia. Orientacja ustali to z samych obrazów; potem można narysować ich pomieszczenie.</translation>
    </message>
    <message>
        <source>These rails are a proposal: nothing of it is stored before you change something.</source>
        <translation>Te szyny to propozycja: nic z niej nie zostanie zapisane, zanim czegoś nie zmienisz.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanPanel</name>
    <message>
        <source>What it comes to</source>
        <translation>Co z tego wynika</translation>
    </message>
    <message>
        <source>Change number</source>
        <translation>Zmiana liczby</translation>
    </message>
    <message>
        <source>Grid and rail</source>
        <translation>Siatka i szyna</translation>
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
        <translation>&amp;Krok</translation>
    </message>
    <message>
        <source>Between neighbouring stations, in both directions.</source>
        <translation>Między sąsiednimi stanowiskami, w obu kierunkach.</translation>
    </message>
    <message>
        <source>&amp;Rail length</source>
        <translation>Długość &amp;szyny</translation>
    </message>
    <message>
        <source>From the first to the last stop of the cart.</source>
        <translation>Od pierwszego do ostatniego postoju wózka.</translation>
    </message>
    <message>
        <source>Least distance from a stop to walls and obstacles.</source>
        <translation>Najmniejsza odległość postoju od ścian i przeszkód.</translation>
    </message>
    <message>
        <source>Of the lens above the floor; several heights, separated by semicolons, make layers.</source>
        <translation>Obiektywu nad podłogą; kilka wysokości rozdzielonych średnikami daje warstwy.</translation>
    </message>
    <message>
        <source>Height of the ceiling above the floor.</source>
        <translation>Wysokość sufitu nad podłogą.</translation>
    </message>
    <message>
        <source>Time a &amp;photo</source>
        <translation>Czas na &amp;zdjęcie</translation>
    </message>
    <message>
        <source>With moving the cart to the next stop.</source>
        <translation>Z przesunięciem wózka na następny postój.</translation>
    </message>
    <message>
        <source>Time a rai&amp;l</source>
        <translation>Czas na sz&amp;ynę</translation>
    </message>
    <message>
        <source>Carrying the rail and laying it anew.</source>
        <translation>Przeniesienie i ułożenie szyny.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Narożniki</translation>
    </message>
    <message numerus="yes">
        <source>%n stop(s)</source>
        <translation>
            <numerusform>%n postój</numerusform>
            <numerusform>%n postoje</numerusform>
            <numerusform>%n postojów</numerusform>
        </translation>
    </message>
    <message>
        <source>Corners of obstacle %1</source>
        <translation>Narożniki przeszkody %1</translation>
    </message>
    <message>
        <source>Corners of the room</source>
        <translation>Narożniki pomieszczenia</translation>
    </message>
    <message>
        <source>Cle&amp;arance</source>
        <translation>Odstęp od ści&amp;an</translation>
    </message>
    <message>
        <source>Len&amp;s height (m)</source>
        <translation>Wysokość obiek&amp;tywu (m)</translation>
    </message>
    <message>
        <source>Ceilin&amp;g</source>
        <translation>Su&amp;fit</translation>
    </message>
    <message>
        <source>Photos by hand, of unknown places</source>
        <translation>Zdjęcia z ręki, miejsca nieznane</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanStorage</name>
    <message>
        <source>The plan is not stored: %1</source>
        <translation>Plan nie został zapisany: %1</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanView</name>
    <message>
        <source>No survey is open</source>
        <translation>Nie otwarto pomiaru</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PlanWords</name>
    <message>
        <source>closer than %L1 m to a wall or an obstacle</source>
        <translation>bliżej niż %L1 m od ściany lub przeszkody</translation>
    </message>
    <message>
        <source>cut off by obstacles</source>
        <translation>odcięte przeszkodami</translation>
    </message>
    <message>
        <source>no stop falls near enough</source>
        <translation>żaden postój nie wypada dość blisko</translation>
    </message>
    <message numerus="yes">
        <source>%n station(s)</source>
        <translation>
            <numerusform>%n stanowisko</numerusform>
            <numerusform>%n stanowiska</numerusform>
            <numerusform>%n stanowisk</numerusform>
        </translation>
    </message>
    <message>
        <source> on </source>
        <translation> na </translation>
    </message>
    <message numerus="yes">
        <source>%n rail(s)</source>
        <translation>
            <numerusform>%n szynie</numerusform>
            <numerusform>%n szynach</numerusform>
            <numerusform>%n szynach</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 m to walk, about %2</source>
        <translation>%L1 m do przejścia, około %2</translation>
    </message>
    <message>
        <source>%L1 m² of floor, %L2 m² not covered (%3 %)</source>
        <translation>%L1 m² podłogi, %L2 m² bez pokrycia (%3 %)</translation>
    </message>
    <message>
        <source>%L1 m²: %2</source>
        <translation>%L1 m²: %2</translation>
    </message>
    <message>
        <source>Marking out: %1</source>
        <translation>Wytyczanie: %1</translation>
    </message>
    <message>
        <source>%1 stations on %2 rails; step %3 cm; rail of %4 stops, %5 m</source>
        <translation>Stanowisk: %1, szyn: %2; krok %3 cm; szyna o %4 postojach, %5 m</translation>
    </message>
    <message>
        <source>Scale 1:%1. Print at 100 %: this bar is 10 cm long.</source>
        <translation>Skala 1:%1. Drukuj w 100 %: ten pasek ma 10 cm.</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Szyna</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Postoje</translation>
    </message>
    <message>
        <source>First stop (ring)</source>
        <translation>Pierwszy postój (okrąg)</translation>
    </message>
    <message>
        <source>Last stop (arrow)</source>
        <translation>Ostatni postój (strzałka)</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Błąd</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Strona %1</translation>
    </message>
    <message>
        <source>Where the rails lie: metres by tape</source>
        <translation>Gdzie leżą szyny: metry taśmą</translation>
    </message>
    <message>
        <source>Error: how far a place is off at most if each tape is read wrong by 5 mm. Below: check and laser.</source>
        <translation>Błąd: o ile miejsce może być przesunięte, jeśli każda taśma jest źle odczytana o 5 mm. Niżej: kontrola i laser.</translation>
    </message>
    <message>
        <source>nothing in sight to measure from</source>
        <translation>nie widać nic, od czego można mierzyć</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>kontrola %1</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>krąg %1</translation>
    </message>
    <message>
        <source>arrow %1</source>
        <translation>strzałka %1</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) by hand</source>
        <translation>
            <numerusform>%n zdjęcie z ręki</numerusform>
            <numerusform>%n zdjęcia z ręki</numerusform>
            <numerusform>%n zdjęć z ręki</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewFeed</name>
    <message>
        <source>The camera sent no picture; start the preview again.</source>
        <translation>Kamera nie przysłała obrazu; uruchom podgląd ponownie.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewMode</name>
    <message>
        <source>Preview</source>
        <translation>Podgląd</translation>
    </message>
    <message>
        <source>Drive a robot and see what its camera would see</source>
        <translation>Prowadź robota i zobacz, co widziałaby jego kamera</translation>
    </message>
    <message>
        <source>Where the robot is</source>
        <translation>Gdzie jest robot</translation>
    </message>
    <message>
        <source>&amp;Preview this survey</source>
        <translation>Podgląd &amp;tego pomiaru</translation>
    </message>
    <message>
        <source>Export the survey to a temporary folder and look at it; nothing is kept</source>
        <translation>Wyeksportuj pomiar do folderu tymczasowego i obejrzyj; nic nie zostaje</translation>
    </message>
    <message>
        <source>Open a &amp;dataset...</source>
        <translation>Otwórz &amp;zbiór danych...</translation>
    </message>
    <message>
        <source>Look at a dataset that was exported before</source>
        <translation>Obejrzyj zbiór danych wyeksportowany wcześniej</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Nagrywaj</translation>
    </message>
    <message>
        <source>Record the path that the robot takes</source>
        <translation>Nagrywaj drogę robota</translation>
    </message>
    <message>
        <source>&amp;Save frames...</source>
        <translation>Zapi&amp;sz klatki...</translation>
    </message>
    <message>
        <source>Render a frame at each pose of the recorded path, as the command walk does</source>
        <translation>Narysuj klatkę w każdej pozycji nagranej drogi, tak jak polecenie walk</translation>
    </message>
    <message>
        <source>Scene model of view %1</source>
        <translation>Model sceny widoku %1</translation>
    </message>
    <message>
        <source>What places between photos are computed with, cheap to exact</source>
        <translation>Z czego oblicza się miejsca między zdjęciami, od taniego do dokładnego</translation>
    </message>
    <message>
        <source>None: nearest photo, turned</source>
        <translation>Brak: najbliższe zdjęcie, obrócone</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kula</translation>
    </message>
    <message>
        <source>Sampling of view %1</source>
        <translation>Próbkowanie widoku %1</translation>
    </message>
    <message>
        <source>How pixels are made, cheap to exact</source>
        <translation>Jak powstają piksele, od taniego do dokładnego</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Najbliższy</translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation>Dwuliniowe</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Zmniejszone</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>Po polu piksela</translation>
    </message>
    <message>
        <source>Bicubic</source>
        <translation>Dwusześcienne</translation>
    </message>
    <message>
        <source>Camera and view</source>
        <translation>Kamera i widok</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source> m high</source>
        <translation> m nad podłogą</translation>
    </message>
    <message>
        <source>Height of the camera above the floor</source>
        <translation>Wysokość kamery nad podłogą</translation>
    </message>
    <message>
        <source>° down</source>
        <translation>° w dół</translation>
    </message>
    <message>
        <source>How far the camera looks below the horizon</source>
        <translation>O ile kamera patrzy poniżej horyzontu</translation>
    </message>
    <message>
        <source>Carried</source>
        <translation>Zawieszona</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>Po&amp;równaj</translation>
    </message>
    <message>
        <source>Show a second view beside the first, made another way</source>
        <translation>Pokaż obok drugi widok, zrobiony inaczej</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Open a dataset</source>
        <translation>Otwórz zbiór danych</translation>
    </message>
    <message>
        <source>Folder for the frames</source>
        <translation>Folder na klatki</translation>
    </message>
    <message>
        <source>Preparing the preview...</source>
        <translation>Przygotowywanie podglądu...</translation>
    </message>
    <message>
        <source>No dataset is open.</source>
        <translation>Nie otwarto zbioru danych.</translation>
    </message>
    <message>
        <source>%1: the survey has changed since; preview it again.</source>
        <translation>%1: pomiar zmienił się od tego czasu; zrób podgląd ponownie.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s)</source>
        <translation>
            <numerusform>%1: %n zdjęcie</numerusform>
            <numerusform>%1: %n zdjęcia</numerusform>
            <numerusform>%1: %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 views/s</source>
        <translation>%1 widoków/s</translation>
    </message>
    <message numerus="yes">
        <source>● %n pose(s)</source>
        <translation>
            <numerusform>● %n pozycja</numerusform>
            <numerusform>● %n pozycje</numerusform>
            <numerusform>● %n pozycji</numerusform>
        </translation>
    </message>
    <message>
        <source>Room: walls, floor, ceiling</source>
        <translation>Pomieszczenie: ściany, podłoga, sufit</translation>
    </message>
    <message>
        <source>Depth of each pixel</source>
        <translation>Głębia każdego piksela</translation>
    </message>
    <message>
        <source>&amp;With depth</source>
        <translation>Z &amp;głębią</translation>
    </message>
    <message>
        <source>Blend: depth, photos mixed</source>
        <translation>Mieszanie: głębia, zdjęcia zmieszane</translation>
    </message>
    <message>
        <source>%1: a sphere stands for the room; depth follows.</source>
        <translation>%1: pokój zastępuje kula; głębia dojdzie.</translation>
    </message>
    <message>
        <source>The depth of each pixel follows while you drive, in surveys of up to %1 photos</source>
        <translation>Głębia każdego piksela dochodzi podczas jazdy, w pomiarach do %1 zdjęć</translation>
    </message>
    <message>
        <source>Sh&amp;ow the expected error</source>
        <translation>Pokaż oczek&amp;iwany błąd</translation>
    </message>
    <message>
        <source>Tints what is displaced: light from half a pixel on, dark at %1 pixels and more</source>
        <translation>Barwi to, co przesunięte: jasno od pół piksela, ciemno od %1 pikseli</translation>
    </message>
    <message>
        <source>%1 (dataset)</source>
        <translation>%1 (zbiór danych)</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) in the dataset</source>
        <translation>
            <numerusform>%n zdjęcie w zbiorze danych</numerusform>
            <numerusform>%n zdjęcia w zbiorze danych</numerusform>
            <numerusform>%n zdjęć w zbiorze danych</numerusform>
        </translation>
    </message>
    <message>
        <source>Its camera</source>
        <translation>Jej kamera</translation>
    </message>
    <message>
        <source>Give the second view another camera than the first</source>
        <translation>Nadaj drugiemu widokowi inną kamerę niż pierwszemu</translation>
    </message>
    <message>
        <source>Camera of view %1</source>
        <translation>Kamera widoku %1</translation>
    </message>
    <message>
        <source>The robot&apos;s own pictures...</source>
        <translation>Własne obrazy robota...</translation>
    </message>
    <message>
        <source>Show what the robot&apos;s camera took beside the view: a CSV file with the columns file, x_m, y_m, z_m, qw, qx, qy, qz</source>
        <translation>Pokaż obok widoku to, co zrobiła kamera robota: plik CSV z kolumnami file, x_m, y_m, z_m, qw, qx, qy, qz</translation>
    </message>
    <message>
        <source>Poses of the robot&apos;s own pictures</source>
        <translation>Pozy własnych obrazów robota</translation>
    </message>
    <message>
        <source>Positions (*.csv)</source>
        <translation>Pozycje (*.csv)</translation>
    </message>
    <message>
        <source>Click to put the robot there, drag to turn it; with Shift, put the object there</source>
        <translation>Kliknij, aby postawić tam robota, przeciągnij, aby go obrócić; z Shift stawiasz tam obiekt</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n photo(s), without depth.</source>
        <translation>
            <numerusform>%1: %n zdjęcie, bez głębi.</numerusform>
            <numerusform>%1: %n zdjęcia, bez głębi.</numerusform>
            <numerusform>%1: %n zdjęć, bez głębi.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is previewed yet.</source>
        <translation>Nie ma jeszcze podglądu.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewPresenter</name>
    <message>
        <source>Opening %1</source>
        <translation>Otwieranie: %1</translation>
    </message>
    <message>
        <source>There is no photo to preview yet; capture or import some first.</source>
        <translation>Nie ma jeszcze zdjęcia do podglądu; najpierw jakieś zrób albo zaimportuj.</translation>
    </message>
    <message>
        <source>Preparing the preview of %1</source>
        <translation>Przygotowywanie podglądu: %1</translation>
    </message>
    <message>
        <source>There is no path to save; record one first.</source>
        <translation>Nie ma drogi do zapisania; najpierw ją nagraj.</translation>
    </message>
    <message numerus="yes">
        <source>Saving %n frame(s)</source>
        <translation>
            <numerusform>Zapisywanie %n klatki</numerusform>
            <numerusform>Zapisywanie %n klatek</numerusform>
            <numerusform>Zapisywanie %n klatek</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n frame(s) to %1.</source>
        <translation>
            <numerusform>Zapisano %n klatkę w %1.</numerusform>
            <numerusform>Zapisano %n klatki w %1.</numerusform>
            <numerusform>Zapisano %n klatek w %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Depth for the preview of %1</source>
        <translation>Głębia dla podglądu %1</translation>
    </message>
    <message>
        <source>How far away that is is not known; click at another place.</source>
        <translation>Nie wiadomo, jak daleko to jest; kliknij w innym miejscu.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::PreviewView</name>
    <message>
        <source>The preview rests while a picture is taken.</source>
        <translation>Podgląd odpoczywa, gdy robione jest zdjęcie.</translation>
    </message>
    <message>
        <source>Waiting for the camera&apos;s first picture...</source>
        <translation>Czekanie na pierwszy obraz z kamery...</translation>
    </message>
    <message>
        <source>The camera has ended its preview.</source>
        <translation>Kamera zakończyła podgląd.</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>Co widzi kamera</translation>
    </message>
    <message>
        <source>%L1 % white</source>
        <translation>%L1 % białe</translation>
    </message>
    <message>
        <source>%L1 % black</source>
        <translation>%L1 % czarne</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ProfileForm</name>
    <message>
        <source>automatic</source>
        <translation>automatycznie</translation>
    </message>
    <message>
        <source>daylight</source>
        <translation>światło dzienne</translation>
    </message>
    <message>
        <source>shade</source>
        <translation>cień</translation>
    </message>
    <message>
        <source>cloudy</source>
        <translation>pochmurno</translation>
    </message>
    <message>
        <source>incandescent</source>
        <translation>żarówka</translation>
    </message>
    <message>
        <source>fluorescent, white</source>
        <translation>świetlówka, biała</translation>
    </message>
    <message>
        <source>fluorescent, warm white</source>
        <translation>świetlówka, ciepła biała</translation>
    </message>
    <message>
        <source>fluorescent, daylight</source>
        <translation>świetlówka, światło dzienne</translation>
    </message>
    <message>
        <source>fluorescent, day white</source>
        <translation>świetlówka, dzienna biała</translation>
    </message>
    <message>
        <source>fluorescent bulb</source>
        <translation>świetlówka kompaktowa</translation>
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
        <translation>tak, jak ustawiono kamerę</translation>
    </message>
    <message>
        <source>Leave it as the camera is set</source>
        <translation>Pozostaw tak, jak ustawiono kamerę</translation>
    </message>
    <message>
        <source>Exposure of the photos</source>
        <translation>Ekspozycja zdjęć</translation>
    </message>
    <message>
        <source>Photos of one room fit each other best if all are exposed alike: fix ISO, shutter time and white balance where the light does not change.</source>
        <translation>Zdjęcia jednego pomieszczenia najlepiej pasują do siebie, gdy wszystkie są naświetlone tak samo: ustal ISO, czas migawki i balans bieli tam, gdzie światło się nie zmienia.</translation>
    </message>
    <message>
        <source>&amp;ISO</source>
        <translation>&amp;ISO</translation>
    </message>
    <message>
        <source>Fixed, or chosen by the camera for each photo.</source>
        <translation>Stałe albo dobierane przez kamerę do każdego zdjęcia.</translation>
    </message>
    <message>
        <source>&amp;Shutter time</source>
        <translation>&amp;Czas migawki</translation>
    </message>
    <message>
        <source>&amp;Brightness</source>
        <translation>&amp;Jasność</translation>
    </message>
    <message>
        <source>How much brighter or darker than the camera thinks right.</source>
        <translation>O ile jaśniej lub ciemniej, niż kamera uważa za właściwe.</translation>
    </message>
    <message>
        <source>&amp;White balance</source>
        <translation>&amp;Balans bieli</translation>
    </message>
    <message>
        <source>The colour of the light.</source>
        <translation>Barwa światła.</translation>
    </message>
    <message>
        <source>&amp;Photo size</source>
        <translation>&amp;Rozmiar zdjęć</translation>
    </message>
    <message>
        <source>Of those that the camera offers.</source>
        <translation>Spośród tych, które kamera oferuje.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>największy</translation>
    </message>
    <message>
        <source>&amp;Keep what the camera chose last: %1</source>
        <translation>Zachowaj to, co kamera wybrała ostat&amp;nio: %1</translation>
    </message>
    <message>
        <source>&amp;Keep what the camera chose last</source>
        <translation>Zachowaj to, co kamera wybrała ostat&amp;nio</translation>
    </message>
    <message>
        <source>ISO and shutter time of the latest photo of this survey.</source>
        <translation>ISO i czas migawki najnowszego zdjęcia tego pomiaru.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RailPanel</name>
    <message>
        <source>Rails</source>
        <translation>Szyny</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Podziel</translation>
    </message>
    <message>
        <source>Make two rails of it, the second from the selected stop on</source>
        <translation>Zrób z niej dwie szyny, drugą od wybranego postoju</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Zablokuj</translation>
    </message>
    <message>
        <source>Keep the rail where it is, also when others are laid anew</source>
        <translation>Pozostaw szynę na miejscu, także gdy inne są układane na nowo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Remove the selected stop or rail (Delete)</source>
        <translation>Usuń wybrany postój lub szynę (Delete)</translation>
    </message>
    <message>
        <source>Lay the others anew</source>
        <translation>Ułóż pozostałe na nowo</translation>
    </message>
    <message>
        <source>Keep the locked rails, and lay out the rest of the floor around them</source>
        <translation>Pozostaw zablokowane szyny i rozplanuj wokół nich resztę podłogi</translation>
    </message>
    <message>
        <source>The program laid all rails.</source>
        <translation>Program ułożył wszystkie szyny.</translation>
    </message>
    <message numerus="yes">
        <source>The program laid the rest around %n locked rail(s).</source>
        <translation>
            <numerusform>Program ułożył resztę wokół %n zablokowanej szyny.</numerusform>
            <numerusform>Program ułożył resztę wokół %n zablokowanych szyn.</numerusform>
            <numerusform>Program ułożył resztę wokół %n zablokowanych szyn.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Laid by hand; %n of them locked.</source>
        <translation>
            <numerusform>Ułożone ręcznie; zablokowana: %n.</numerusform>
            <numerusform>Ułożone ręcznie; zablokowane: %n.</numerusform>
            <numerusform>Ułożone ręcznie; zablokowanych: %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rail %1: %n stop(s), %L2 m, heading %3°</source>
        <translation>
            <numerusform>Szyna %1: %n postój, %L2 m, kierunek %3°</numerusform>
            <numerusform>Szyna %1: %n postoje, %L2 m, kierunek %3°</numerusform>
            <numerusform>Szyna %1: %n postojów, %L2 m, kierunek %3°</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Odblokuj</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RailTool</name>
    <message>
        <source>Drag a rail to move it, its first or last stop to turn and lengthen it (Shift: without a turn), or free floor to lay a rail. Ctrl+arrows turn it or change its length; Delete removes a stop or a rail.</source>
        <translation>Przeciągnij szynę, aby ją przesunąć, jej pierwszy lub ostatni postój, aby ją obrócić i wydłużyć (Shift: bez obrotu), albo wolną podłogę, aby ułożyć szynę. Ctrl+strzałki obracają ją lub zmieniają jej długość; Delete usuwa postój lub szynę.</translation>
    </message>
    <message>
        <source>Pull rail</source>
        <translation>Pociągnij szynę</translation>
    </message>
    <message>
        <source>Move rail</source>
        <translation>Przesuń szynę</translation>
    </message>
    <message>
        <source>Turn rail</source>
        <translation>Obróć szynę</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>Zmień długość</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RecentSurveys</name>
    <message>
        <source>%1 of %2 photos, %3</source>
        <translation>%1 z %2 zdjęć, %3</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RegionBar</name>
    <message>
        <source>Hide a region</source>
        <translation>Ukryj obszar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>As e&amp;xported</source>
        <translation>&amp;Jak w eksporcie</translation>
    </message>
    <message>
        <source>Put a box around a face, a screen or a sheet of paper: exports show it blurred (%1)</source>
        <translation>Załóż ramkę na twarz, ekran albo kartkę: eksporty pokażą to zamazane (%1)</translation>
    </message>
    <message>
        <source>Remove the selected region</source>
        <translation>Usuń wybrany obszar</translation>
    </message>
    <message>
        <source>Let exports show the selected region again (Delete in the photo); click or Tab selects one</source>
        <translation>Niech eksporty znów pokazują wybrany obszar (Delete na zdjęciu); wybiera kliknięcie lub Tab</translation>
    </message>
    <message>
        <source>Show the photo as exports have it, with its private regions blurred</source>
        <translation>Pokaż zdjęcie tak, jak mają je eksporty, z zamazanymi obszarami prywatnymi</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RemoteForm</name>
    <message>
        <source>Phone as remote</source>
        <translation>Telefon jako pilot</translation>
    </message>
    <message>
        <source>This computer&apos;s address in the network that the phone is in, too.</source>
        <translation>Adres tego komputera w sieci, w której jest też telefon.</translation>
    </message>
    <message>
        <source>Nothing is encrypted on the way: whoever can listen in this network can read along and take the remote over. Use a network that you trust, and turn the remote off when you are done.</source>
        <translation>Po drodze nic nie jest szyfrowane: kto może podsłuchiwać tę sieć, może wszystko odczytać i przejąć pilota. Używaj sieci, której ufasz, i wyłącz pilota po skończonej pracy.</translation>
    </message>
    <message>
        <source>A phone or tablet on the cart shows the next station, shoots, and shows the last photo. Open the address in its browser, and type the code there.</source>
        <translation>Telefon lub tablet na wózku pokazuje następne stanowisko, wyzwala zdjęcie i pokazuje ostatnie zdjęcie. Otwórz ten adres w jego przeglądarce i wpisz tam kod.</translation>
    </message>
    <message>
        <source>&amp;Network:</source>
        <translation>&amp;Sieć:</translation>
    </message>
    <message>
        <source>Address:</source>
        <translation>Adres:</translation>
    </message>
    <message>
        <source>Code:</source>
        <translation>Kod:</translation>
    </message>
    <message>
        <source>This computer is in no local network. Connect it to the network that the phone is in.</source>
        <translation>Ten komputer nie jest w żadnej sieci lokalnej. Połącz go z siecią, w której jest telefon.</translation>
    </message>
    <message>
        <source>The device at %1 is the remote.</source>
        <translation>Pilotem jest urządzenie o adresie %1.</translation>
    </message>
    <message>
        <source>Wrong codes came too often, and the code is void. Make a new one.</source>
        <translation>Przyszło zbyt wiele błędnych kodów i kod jest nieważny. Utwórz nowy.</translation>
    </message>
    <message>
        <source>No device is paired yet.</source>
        <translation>Żadne urządzenie nie jest jeszcze sparowane.</translation>
    </message>
    <message>
        <source>&amp;Turn off</source>
        <translation>&amp;Wyłącz</translation>
    </message>
    <message>
        <source>&amp;Turn on</source>
        <translation>&amp;Włącz</translation>
    </message>
    <message>
        <source>&amp;Let go of the device</source>
        <translation>&amp;Odłącz urządzenie</translation>
    </message>
    <message>
        <source>New &amp;code</source>
        <translation>Nowy &amp;kod</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewDelegate</name>
    <message>
        <source>no photo</source>
        <translation>bez zdjęcia</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>nieczytelne</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewMode</name>
    <message>
        <source>Review</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Look at the photos, and accept or reject them</source>
        <translation>Oglądaj zdjęcia, przyjmuj je i odrzucaj</translation>
    </message>
    <message>
        <source>Which stations are listed</source>
        <translation>Które stanowiska są na liście</translation>
    </message>
    <message>
        <source>Station, file or note</source>
        <translation>Stanowisko, plik lub notatka</translation>
    </message>
    <message>
        <source>Text that listed stations contain</source>
        <translation>Tekst, który zawierają stanowiska z listy</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Stanowiska</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>One photo</source>
        <translation>Jedno zdjęcie</translation>
    </message>
    <message>
        <source>Blink with</source>
        <translation>Na zmianę z</translation>
    </message>
    <message>
        <source>Slider with</source>
        <translation>Suwak z</translation>
    </message>
    <message>
        <source>How the photo is compared</source>
        <translation>Jak porównuje się zdjęcie</translation>
    </message>
    <message>
        <source>Compare the photo with a neighbour: C for the next way</source>
        <translation>Porównaj zdjęcie z sąsiadem: C wybiera następny sposób</translation>
    </message>
    <message>
        <source>Neighbour to compare with</source>
        <translation>Sąsiad do porównania</translation>
    </message>
    <message>
        <source>The neighbour to compare with: N for the next one</source>
        <translation>Sąsiad do porównania: N wybiera następnego</translation>
    </message>
    <message>
        <source>Next way to compare</source>
        <translation>Następny sposób porównania</translation>
    </message>
    <message>
        <source>Next neighbour</source>
        <translation>Następny sąsiad</translation>
    </message>
    <message>
        <source>Note on this photo (M)</source>
        <translation>Notatka do tego zdjęcia (M)</translation>
    </message>
    <message>
        <source>Note on this photo</source>
        <translation>Notatka do tego zdjęcia</translation>
    </message>
    <message>
        <source>Write a note</source>
        <translation>Napisz notatkę</translation>
    </message>
    <message>
        <source> Accept</source>
        <translation> Przyjmij</translation>
    </message>
    <message>
        <source>Accept the photo and go on</source>
        <translation>Przyjmij zdjęcie i przejdź dalej</translation>
    </message>
    <message>
        <source> Reject</source>
        <translation> Odrzuć</translation>
    </message>
    <message>
        <source>Reject the photo: it is left out of datasets and is to be taken again</source>
        <translation>Odrzuć zdjęcie: nie trafi do zbiorów danych i trzeba je będzie powtórzyć</translation>
    </message>
    <message>
        <source>Reopen</source>
        <translation>Otwórz ponownie</translation>
    </message>
    <message>
        <source>Withdraw the decision</source>
        <translation>Wycofaj decyzję</translation>
    </message>
    <message>
        <source>Next photo</source>
        <translation>Następne zdjęcie</translation>
    </message>
    <message>
        <source>Previous photo</source>
        <translation>Poprzednie zdjęcie</translation>
    </message>
    <message>
        <source>What the plan shows</source>
        <translation>Co pokazuje plan</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Pokrycie</translation>
    </message>
    <message>
        <source>Residuals of the alignment</source>
        <translation>Resztki orientacji</translation>
    </message>
    <message>
        <source>Uncertainty of the headings</source>
        <translation>Niepewność kierunków</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, %2 cm away</source>
        <translation>%1, w odległości %2 cm</translation>
    </message>
    <message>
        <source>Measured errors of views</source>
        <translation>Zmierzone błędy widoków</translation>
    </message>
    <message>
        <source>Report...</source>
        <translation>Raport...</translation>
    </message>
    <message>
        <source>Take the errors from another report.json</source>
        <translation>Weź błędy z innego pliku report.json</translation>
    </message>
    <message>
        <source>Report of a measured dataset</source>
        <translation>Raport zmierzonego zbioru danych</translation>
    </message>
    <message>
        <source>Report (report.json *.json)</source>
        <translation>Raport (report.json *.json)</translation>
    </message>
    <message>
        <source>Accept every photo that the checks and the alignment call good</source>
        <translation>Przyjmij każde zdjęcie, które kontrole i orientacja uznają za dobre</translation>
    </message>
    <message>
        <source>Judge the photos that no check has seen, such as imported ones</source>
        <translation>Oceń zdjęcia, których nie widziała żadna kontrola, na przykład importowane</translation>
    </message>
    <message>
        <source>Align first</source>
        <translation>Najpierw orientacja</translation>
    </message>
    <message>
        <source>Photos that are not aligned may be turned differently</source>
        <translation>Zdjęcia bez orientacji mogą być różnie obrócone</translation>
    </message>
    <message>
        <source>Accept all &amp;good ones (%1)</source>
        <translation>Przyjmij wszystkie &amp;dobre (%1)</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Check %n photo(s)</source>
        <translation>
            <numerusform>&amp;Sprawdź %n zdjęcie</numerusform>
            <numerusform>&amp;Sprawdź %n zdjęcia</numerusform>
            <numerusform>&amp;Sprawdź %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>Tab, Delete</source>
        <translation>Tab, Delete</translation>
    </message>
    <message>
        <source>In the photo: select a private region, remove it</source>
        <translation>Na zdjęciu: wybierz obszar prywatny, usuń go</translation>
    </message>
    <message>
        <source>arrows, Shift+arrows, Return</source>
        <translation>strzałki, Shift+strzałki, Enter</translation>
    </message>
    <message>
        <source>While a region is being hidden: move the box, size it, store it</source>
        <translation>Przy ukrywaniu obszaru: przesuń ramkę, zmień jej rozmiar, zapisz ją</translation>
    </message>
    <message>
        <source>Contact sheet</source>
        <translation>Arkusz stykowy</translation>
    </message>
    <message>
        <source>Show the listed photos beside each other, in place of one photo and the plan</source>
        <translation>Pokaż zdjęcia z listy obok siebie, zamiast jednego zdjęcia i planu</translation>
    </message>
    <message>
        <source>Story</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Tell what became of this photo: taken, judged, moved, aligned, decided</source>
        <translation>Pokaż, co się działo z tym zdjęciem: wykonane, ocenione, przeniesione, wyrównane, rozstrzygnięte</translation>
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
        <translation>95 ze 100 miejsc widoków z tego punktu jest przesuniętych najwyżej o %1.</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nie znaleziono</translation>
    </message>
    <message>
        <source>More than 5 of 100 places were not found in views in its place.</source>
        <translation>Ponad 5 na 100 miejsc nie znaleziono w widokach z jego miejsca.</translation>
    </message>
    <message numerus="yes">
        <source>%n private region(s), which exports show blurred</source>
        <translation>
            <numerusform>%n obszar prywatny, który eksporty pokazują zamazany</numerusform>
            <numerusform>%n obszary prywatne, które eksporty pokazują zamazane</numerusform>
            <numerusform>%n obszarów prywatnych, które eksporty pokazują zamazane</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::ReviewPresenter</name>
    <message>
        <source>%1 accepted, %2 rejected, %3 to be reviewed, %4 missing</source>
        <translation>przyjęte: %1, odrzucone: %2, do oceny: %3, brak: %4</translation>
    </message>
    <message>
        <source>The report %1 is of another survey&apos;s dataset, %2.</source>
        <translation>Raport %1 dotyczy zbioru danych innego pomiaru, %2.</translation>
    </message>
    <message>
        <source>No dataset of this survey has been measured yet: do so in Export, or choose the report.json of one that was.</source>
        <translation>Żaden zbiór danych tego pomiaru nie został jeszcze zmierzony: zrób to w Eksporcie albo wskaż plik report.json.</translation>
    </message>
    <message>
        <source>Displacement of 95 of 100 places, where the photo was left out of %1; scene model %2, tolerance %L3 px.</source>
        <translation>Przesunięcie 95 ze 100 miejsc, gdy zdjęcie pominięto w %1; model sceny: %2, tolerancja %L3 px.</translation>
    </message>
    <message>
        <source>Checking photos</source>
        <translation>Sprawdzanie zdjęć</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) checked: %1 good, %2 doubtful, %3 failed.</source>
        <translation>
            <numerusform>Sprawdzono %n zdjęcie: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
            <numerusform>Sprawdzono %n zdjęcia: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
            <numerusform>Sprawdzono %n zdjęć: %1 dobrych, %2 wątpliwych, %3 nieudanych.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) searched</source>
        <translation>
            <numerusform>Przeszukano %n zdjęcie</numerusform>
            <numerusform>Przeszukano %n zdjęcia</numerusform>
            <numerusform>Przeszukano %n zdjęć</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: no face found.</source>
        <translation>%1: nie znaleziono twarzy.</translation>
    </message>
    <message>
        <source>%1: %2 %3, which exports show blurred.</source>
        <translation>%1: %2 %3; eksporty pokażą je zamazane.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) found</source>
        <translation>
            <numerusform>%n twarz</numerusform>
            <numerusform>%n twarze</numerusform>
            <numerusform>%n twarzy</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n photo(s)</source>
        <translation>
            <numerusform>na %n zdjęciu</numerusform>
            <numerusform>na %n zdjęciach</numerusform>
            <numerusform>na %n zdjęciach</numerusform>
        </translation>
    </message>
    <message>
        <source>Searching for faces</source>
        <translation>Szukanie twarzy</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RobotMap</name>
    <message>
        <source>No dataset is open</source>
        <translation>Żaden zbiór danych nie jest otwarty</translation>
    </message>
    <message>
        <source>Nothing is previewed yet</source>
        <translation>Nie ma jeszcze podglądu</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::RungWords</name>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>kula</translation>
    </message>
    <message>
        <source>room</source>
        <translation>pomieszczenie</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>głębia</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>najbliższy piksel</translation>
    </message>
    <message>
        <source>bilinear</source>
        <translation>dwuliniowe</translation>
    </message>
    <message>
        <source>reduced</source>
        <translation>zmniejszone</translation>
    </message>
    <message>
        <source>footprint</source>
        <translation>po polu piksela</translation>
    </message>
    <message>
        <source>bicubic</source>
        <translation>dwusześcienne</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>wedle potrzeby</translation>
    </message>
    <message>
        <source>Best there is</source>
        <translation>Najlepszy, jaki jest</translation>
    </message>
    <message>
        <source>Best there is: %1</source>
        <translation>Najlepszy, jaki jest: %1</translation>
    </message>
    <message>
        <source>As measured: %1, cheaper where enough</source>
        <translation>Jak zmierzono: %1, taniej, gdzie wystarczy</translation>
    </message>
    <message>
        <source>As measured: %1</source>
        <translation>Jak zmierzono: %1</translation>
    </message>
    <message>
        <source>As needed</source>
        <translation>Wedle potrzeby</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>mieszanie</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StartPage</name>
    <message>
        <source>Recent surveys</source>
        <translation>Ostatnie pomiary</translation>
    </message>
    <message>
        <source>Spherewalk</source>
        <translation>Spherewalk</translation>
    </message>
    <message>
        <source>Scan a room with a spherical camera, and let robots see it.</source>
        <translation>Zeskanuj pomieszczenie kamerą sferyczną i pokaż je robotom.</translation>
    </message>
    <message>
        <source>&amp;Try the practice room</source>
        <translation>W&amp;ypróbuj pokój ćwiczebny</translation>
    </message>
    <message>
        <source>Makes a survey of a room that exists only in the program, and photographs it.</source>
        <translation>Tworzy pomiar pokoju, który istnieje tylko w programie, i go fotografuje.</translation>
    </message>
    <message>
        <source>No camera is needed: the program has one inside, which photographs a furnished room while you watch. It takes about a minute.</source>
        <translation>Kamera nie jest potrzebna: program ma własną, która na Twoich oczach fotografuje umeblowany pokój. Trwa to około minuty.</translation>
    </message>
    <message>
        <source>&amp;New survey</source>
        <translation>&amp;Nowy pomiar</translation>
    </message>
    <message>
        <source>Draw a room and lay out its stations.</source>
        <translation>Narysuj pomieszczenie i rozplanuj stanowiska.</translation>
    </message>
    <message>
        <source>&amp;Open a survey...</source>
        <translation>&amp;Otwórz pomiar...</translation>
    </message>
    <message>
        <source>A folder whose name ends in .spherewalk.</source>
        <translation>Folder o nazwie kończącej się na .spherewalk.</translation>
    </message>
    <message>
        <source>Take the tour, in five steps</source>
        <translation>Zwiedzanie w pięciu krokach</translation>
    </message>
    <message>
        <source>Leads through all pages with the practice room.</source>
        <translation>Prowadzi przez wszystkie strony z pokojem ćwiczebnym.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StationQueue</name>
    <message>
        <source>%1: %2 of %3 taken</source>
        <translation>%1: zrobiono %2 z %3</translation>
    </message>
    <message>
        <source>Photo %1</source>
        <translation>Zdjęcie %1</translation>
    </message>
    <message>
        <source>Hold the camera upright and still. Take the next photo about half a metre on.</source>
        <translation>Trzymaj kamerę pionowo i nieruchomo. Następne zdjęcie zrób około pół metra dalej.</translation>
    </message>
    <message numerus="yes">
        <source>%n photo(s) found their place. Walk on about half a metre.</source>
        <translation>
            <numerusform>%n zdjęcie znalazło swoje miejsce. Przejdź około pół metra dalej.</numerusform>
            <numerusform>%n zdjęcia znalazły swoje miejsce. Przejdź około pół metra dalej.</numerusform>
            <numerusform>%n zdjęć znalazło swoje miejsce. Przejdź około pół metra dalej.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 photos found their place. Take some between the others and these.</source>
        <translation>Swoje miejsce znalazło %1 z %2 zdjęć. Zrób kilka między pozostałymi a tymi.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StationWords</name>
    <message>
        <source>x %L1, y %L2</source>
        <translation>x %L1, y %L2</translation>
    </message>
    <message>
        <source>%1 %L2 m</source>
        <translation>%1 %L2 m</translation>
    </message>
    <message>
        <source>Rail %1, stop %2</source>
        <translation>Szyna %1, postój %2</translation>
    </message>
    <message>
        <source>%1, at %L2 m</source>
        <translation>%1, na %L2 m</translation>
    </message>
    <message>
        <source>x %L1 m, y %L2 m, lens at %L3 m</source>
        <translation>x %L1 m, y %L2 m, obiektyw na %L3 m</translation>
    </message>
    <message>
        <source>Lay the rail. First stop: %1. Last stop: %2.</source>
        <translation>Ułóż szynę. Pierwszy postój: %1. Ostatni: %2.</translation>
    </message>
    <message>
        <source>ring %1</source>
        <translation>krąg %1</translation>
    </message>
    <message>
        <source>arrow %1</source>
        <translation>strzałka %1</translation>
    </message>
    <message>
        <source>%1 (check: %2)</source>
        <translation>%1 (kontrola: %2)</translation>
    </message>
    <message>
        <source>Unknown place %1</source>
        <translation>Nieznane miejsce %1</translation>
    </message>
    <message>
        <source>Unknown place of %1</source>
        <translation>Nieznane miejsce zdjęcia %1</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Miejsce zdjęcia %1</translation>
    </message>
    <message>
        <source>At x %L1, y %L2</source>
        <translation>W x %L1, y %L2</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::StoryWords</name>
    <message>
        <source>Taken %1 as %2</source>
        <translation>Wykonano %1 jako %2</translation>
    </message>
    <message>
        <source>Taken as %1, it does not say when</source>
        <translation>Wykonano jako %1, bez podanego czasu</translation>
    </message>
    <message>
        <source>, by the camera %1</source>
        <translation>, aparatem %1</translation>
    </message>
    <message>
        <source>%1%2; stored %3.</source>
        <translation>%1%2; zapisano %3.</translation>
    </message>
    <message>
        <source>No check has judged it.</source>
        <translation>Żadne sprawdzenie go nie oceniło.</translation>
    </message>
    <message>
        <source>The checks found nothing.</source>
        <translation>Sprawdzenia niczego nie wykryły.</translation>
    </message>
    <message numerus="yes">
        <source>The checks found %n thing(s).</source>
        <translation>
            <numerusform>Sprawdzenia wykryły %n rzecz.</numerusform>
            <numerusform>Sprawdzenia wykryły %n rzeczy.</numerusform>
            <numerusform>Sprawdzenia wykryły %n rzeczy.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is not aligned yet.</source>
        <translation>Nie jest jeszcze wyrównane.</translation>
    </message>
    <message>
        <source>The alignment of %1 found no heading for it.</source>
        <translation>Wyrównanie z %1 nie znalazło jego kierunku.</translation>
    </message>
    <message>
        <source>Aligned %1: it looks along %L2 degrees, known to %L3 degrees.</source>
        <translation>Wyrównano %1: patrzy w kierunku %L2 stopni, znanym z dokładnością %L3 stopnia.</translation>
    </message>
    <message>
        <source>Aligned %1: it looks along %L2 degrees.</source>
        <translation>Wyrównano %1: patrzy w kierunku %L2 stopni.</translation>
    </message>
    <message>
        <source>Somebody has accepted it.</source>
        <translation>Ktoś je przyjął.</translation>
    </message>
    <message>
        <source>Somebody has rejected it.</source>
        <translation>Ktoś je odrzucił.</translation>
    </message>
    <message>
        <source>Nobody has decided on it yet.</source>
        <translation>Nikt jeszcze o nim nie zdecydował.</translation>
    </message>
    <message>
        <source>Moved here from %1, where it was tagged first.</source>
        <translation>Przeniesione tu z %1, gdzie było najpierw przypisane.</translation>
    </message>
    <message numerus="yes">
        <source>The station has %n other photo(s).</source>
        <translation>
            <numerusform>Stanowisko ma jeszcze %n zdjęcie.</numerusform>
            <numerusform>Stanowisko ma jeszcze %n zdjęcia.</numerusform>
            <numerusform>Stanowisko ma jeszcze %n zdjęć.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::SurveyPlanView</name>
    <message>
        <source>Nobody knows this room yet, nor where its photos stand</source>
        <translation>Tego pomieszczenia jeszcze nie znamy, ani miejsc jego zdjęć</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Task</name>
    <message>
        <source>Spherewalk met a defect of its own: %1.</source>
        <translation>Spherewalk natrafił na własny błąd: %1.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::TaskBar</name>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, zostało %2</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Zatrzymaj</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Zatrzymaj: %1</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::TaskPanel</name>
    <message>
        <source>Stop; what is complete stays</source>
        <translation>Zatrzymaj; to, co gotowe, zostaje</translation>
    </message>
    <message>
        <source>done</source>
        <translation>gotowe</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zatrzymane</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>Nic nie trwa.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Told</name>
    <message>
        <source>Open a survey</source>
        <translation>Otwórz pomiar</translation>
    </message>
    <message>
        <source>Go to Plan</source>
        <translation>Przejdź do: Plan</translation>
    </message>
    <message>
        <source>Go to Capture</source>
        <translation>Przejdź do: Zdjęcia</translation>
    </message>
    <message>
        <source>Change the address</source>
        <translation>Zmień adres</translation>
    </message>
    <message>
        <source>What the guide says</source>
        <translation>Co mówi przewodnik</translation>
    </message>
    <message>
        <source>Change the exposure</source>
        <translation>Zmień ekspozycję</translation>
    </message>
    <message>
        <source>Go to Review</source>
        <translation>Przejdź do: Ocena</translation>
    </message>
    <message>
        <source>Go to Align</source>
        <translation>Przejdź do: Orientacja</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Wybierz folder</translation>
    </message>
    <message>
        <source>Export with depth</source>
        <translation>Eksportuj z głębią</translation>
    </message>
    <message>
        <source>Look at them</source>
        <translation>Zobacz je</translation>
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
        <translation>Tolerancja</translation>
    </message>
    <message>
        <source>Pixels of the robot&apos;s camera that 95 of 100 places of a view may be displaced by</source>
        <translation>O ile pikseli kamery robota może być przesuniętych 95 na 100 miejsc widoku</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::Tour</name>
    <message>
        <source>This is the plan of a practice room: walls, furniture, and rails with their stops. A ring is where a rail begins. The Sheet tells how to lay the rails with a tape.</source>
        <translation>To plan pokoju ćwiczebnego: ściany, meble i szyny z postojami. Okrąg to początek szyny. Arkusz mówi, jak ułożyć szyny z taśmą mierniczą.</translation>
    </message>
    <message>
        <source>The practice camera now takes the photos by itself. With a real camera, bring it to the cross on the plan and press Space.</source>
        <translation>Kamera ćwiczebna robi teraz zdjęcia sama. Prawdziwą kamerę ustaw przy krzyżyku na planie i naciśnij spację.</translation>
    </message>
    <message>
        <source>Look at the photos: J and K go from one to the next, A accepts, R rejects. What the checks found is outlined in the photo. C compares with a neighbour.</source>
        <translation>Obejrzyj zdjęcia: J i K przechodzą między nimi, A przyjmuje, R odrzuca. To, co znalazły kontrole, jest obwiedzione na zdjęciu. C porównuje z sąsiadem.</translation>
    </message>
    <message>
        <source>Press Align. It solves how each photo is turned, and finds stations that were mixed up.</source>
        <translation>Naciśnij Wyznacz. To ustala, jak obrócone jest każde zdjęcie, i znajduje pomylone stanowiska.</translation>
    </message>
    <message>
        <source>Press Preview this survey, click into the view, and drive with W A S D. That is what a robot would see. Export writes it for simulators.</source>
        <translation>Naciśnij Podgląd tego pomiaru, kliknij w widok i jedź klawiszami W A S D. To widziałby robot. Eksport zapisuje to dla symulatorów.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Zwiedzanie</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Zakończ zwiedzanie</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2.&lt;/b&gt; %3</source>
        <translation>&lt;b&gt;%1 z %2.&lt;/b&gt; %3</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Gotowe</translation>
    </message>
</context>
</TS>
