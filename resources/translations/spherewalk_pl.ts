<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl">
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
    <name>spherewalk::ui::Application</name>
    <message>
        <source>Spherewalk met a defect of its own: %1.</source>
        <translation>Spherewalk natrafił na własny błąd: %1.</translation>
    </message>
</context>
<context>
    <name>spherewalk::ui::CameraPanel</name>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Połącz</translation>
    </message>
    <message>
        <source>&amp;Practice camera</source>
        <translation>&amp;Kamera ćwiczebna</translation>
    </message>
    <message>
        <source>Shoot by &amp;itself</source>
        <translation>Fotografuj &amp;samoczynnie</translation>
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
        <source>Start a camera inside of the program, which photographs a practice room.</source>
        <translation>Uruchom kamerę wewnątrz programu, która fotografuje pokój ćwiczebny.</translation>
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
        <source>Time to &amp;hide:</source>
        <translation>Czas na &amp;ukrycie:</translation>
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
        <source>Take the photos, station by station.</source>
        <translation>Rób zdjęcia, stanowisko po stanowisku.</translation>
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
        <source>Do not take it again</source>
        <translation>Nie powtarzaj</translation>
    </message>
    <message>
        <source>Take the selected station again</source>
        <translation>Powtórz zaznaczone stanowisko</translation>
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
        <source>practice room %1</source>
        <translation>pokój ćwiczebny %1</translation>
    </message>
    <message>
        <source>Spherewalk %1, free software under the GNU General Public License, version 3 or later.</source>
        <translation>Spherewalk %1, wolne oprogramowanie na licencji GNU GPL w wersji 3 lub późniejszej.</translation>
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
        <translation>&amp;Utwórz pomiar</translation>
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
        <translation>&amp;Miejsce</translation>
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
    <name>spherewalk::ui::PlanCanvas</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
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
</context>
<context>
    <name>spherewalk::ui::PlanEditorView</name>
    <message>
        <source>%1 m² not covered</source>
        <translation>%1 m² bez pokrycia</translation>
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
</context>
<context>
    <name>spherewalk::ui::PlanMode</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Draw the room and lay out where photos are to be taken.</source>
        <translation>Narysuj pomieszczenie i rozplanuj miejsca zdjęć.</translation>
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
        <source>Remove the selected corner or obstacle (Delete)</source>
        <translation>Usuń zaznaczony narożnik lub przeszkodę (Delete)</translation>
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
        <source>Pictures (*.png *.jpg *.jpeg *.svg *.bmp)</source>
        <translation>Obrazy (*.png *.jpg *.jpeg *.svg *.bmp)</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read.</source>
        <translation>%1 nie jest obrazem, który da się odczytać.</translation>
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
        <source>C&amp;learance</source>
        <translation>&amp;Odstęp</translation>
    </message>
    <message>
        <source>Least distance from a stop to walls and obstacles.</source>
        <translation>Najmniejsza odległość postoju od ścian i przeszkód.</translation>
    </message>
    <message>
        <source>Lens &amp;height (m)</source>
        <translation>&amp;Wysokość obiektywu (m)</translation>
    </message>
    <message>
        <source>Of the lens above the floor; several heights, separated by semicolons, make layers.</source>
        <translation>Obiektywu nad podłogą; kilka wysokości rozdzielonych średnikami daje warstwy.</translation>
    </message>
    <message>
        <source>Ce&amp;iling</source>
        <translation>Su&amp;fit</translation>
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
        <source>Plan of the room</source>
        <translation>Plan pomieszczenia</translation>
    </message>
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
        <source>Where the rails lie: tape distances in metres from the corners of the room</source>
        <translation>Położenie szyn: odległości taśmą w metrach od narożników</translation>
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
        <source>no two corners in sight: x %1, y %2</source>
        <translation>nie widać dwóch narożników: x %1, y %2</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Strona %1</translation>
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
        <translation>&amp;Wypróbuj pokój ćwiczebny</translation>
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
        <source>%1   (%2)</source>
        <translation>%1   (%2)</translation>
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
</context>
<context>
    <name>spherewalk::ui::SurveyPlanView</name>
    <message>
        <source>no photo yet</source>
        <translation>jeszcze bez zdjęcia</translation>
    </message>
    <message>
        <source>has a photo</source>
        <translation>ma zdjęcie</translation>
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
    <name>spherewalk::ui::TaskPanel</name>
    <message>
        <source>Stop; what is complete stays</source>
        <translation>Zatrzymaj; to, co gotowe, zostaje</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Zatrzymaj: %1</translation>
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
        <source>%1 left</source>
        <translation>zostało %1</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>Nic nie trwa.</translation>
    </message>
</context>
</TS>
