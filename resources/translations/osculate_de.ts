<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The edge that arrives at the join</source>
        <extracomment>JoinReports of the inner knots, and of the closing</extracomment>
        <translation>Die Kante, die am Übergang ankommt</translation>
    </message>
    <message>
        <source>The edge that leaves the join</source>
        <translation>Die Kante, die den Übergang verlässt</translation>
    </message>
    <message>
        <source>Which end of the first and of the second edge meet</source>
        <translation>Welches Ende der ersten und der zweiten Kante sich treffen</translation>
    </message>
    <message>
        <source>Number of an inner knot of the first edge, 0 for a join at ends</source>
        <translation>Nummer eines inneren Knotens der ersten Kante, 0 für einen Übergang an den Enden</translation>
    </message>
    <message>
        <source>Highest order analysed, 0 to 8</source>
        <extracomment>A group as in properties.add_properties, and what its properties begin with.</extracomment>
        <translation>Höchste untersuchte Ordnung, 0 bis 8</translation>
    </message>
    <message>
        <source>Tolerances of Osculate, of another system, or custom</source>
        <translation>Toleranzen von Osculate, eines anderen Systems oder eigene</translation>
    </message>
    <message>
        <source>Largest distance of the ends that passes G0</source>
        <extracomment>Names of the presets, in the order in which they are offered.</extracomment>
        <translation>Größter Abstand der Enden, der G0 besteht</translation>
    </message>
    <message>
        <source>Largest angle between the tangents that passes G1</source>
        <translation>Größter Winkel der Tangenten, der G1 besteht</translation>
    </message>
    <message>
        <source>Largest relative deviation of curvature that passes G2</source>
        <translation>Größte relative Abweichung der Krümmung, die G2 besteht</translation>
    </message>
    <message>
        <source>Largest relative deviation of the third derivative that passes G3</source>
        <translation>Größte relative Abweichung der dritten Ableitung, die G3 besteht</translation>
    </message>
    <message>
        <source>Largest relative deviation that passes G4 and above</source>
        <translation>Größte relative Abweichung, die G4 und höher besteht</translation>
    </message>
    <message>
        <source>OK, or why there is no result</source>
        <translation>OK, oder warum es kein Ergebnis gibt</translation>
    </message>
    <message>
        <source>G0 to G8, gap, or error</source>
        <translation>G0 bis G8, gap (Lücke) oder error (Fehler)</translation>
    </message>
    <message>
        <source>Order of geometric continuity, -1 for a gap</source>
        <translation>Ordnung der geometrischen Stetigkeit, -1 bei einer Lücke</translation>
    </message>
    <message>
        <source>Order of parametric continuity, -1 for a gap</source>
        <translation>Ordnung der parametrischen Stetigkeit, -1 bei einer Lücke</translation>
    </message>
    <message>
        <source>The verdict in one line</source>
        <translation>Das Urteil in einer Zeile</translation>
    </message>
    <message>
        <source>pass, fail or undecided for each order from 0</source>
        <translation>pass, fail oder undecided für jede Ordnung ab 0</translation>
    </message>
    <message>
        <source>Deviation of each order from 0: mm, degrees, then relative</source>
        <translation>Abweichung jeder Ordnung ab 0: mm, Grad, dann relativ</translation>
    </message>
    <message>
        <source>The end of the first edge at the join</source>
        <translation>Das Ende der ersten Kante am Übergang</translation>
    </message>
    <message>
        <source>Version of this object&apos;s properties</source>
        <translation>Version der Eigenschaften dieses Objekts</translation>
    </message>
    <message>
        <source>The whole report as JSON, schema osculate.join/1</source>
        <translation>Der ganze Bericht als JSON, Schema osculate.join/1</translation>
    </message>
    <message>
        <source>Distance of the two ends</source>
        <extracomment>Key in the report&apos;s deviation (or of a side) -&gt; property. NaN and hidden where it does not exist.</extracomment>
        <translation>Abstand der beiden Enden</translation>
    </message>
    <message>
        <source>Angle between the tangents in the direction of travel</source>
        <translation>Winkel zwischen den Tangenten in Laufrichtung</translation>
    </message>
    <message>
        <source>Angle between the binormals</source>
        <translation>Winkel zwischen den Binormalen</translation>
    </message>
    <message>
        <source>Radius of curvature of the first edge at the join</source>
        <translation>Krümmungsradius der ersten Kante am Übergang</translation>
    </message>
    <message>
        <source>Radius of curvature of the second edge at the join</source>
        <translation>Krümmungsradius der zweiten Kante am Übergang</translation>
    </message>
    <message>
        <source>Curvature of the first edge at the join, 1/mm</source>
        <translation>Krümmung der ersten Kante am Übergang, 1/mm</translation>
    </message>
    <message>
        <source>Curvature of the second edge at the join, 1/mm</source>
        <translation>Krümmung der zweiten Kante am Übergang, 1/mm</translation>
    </message>
    <message>
        <source>Length of the difference of the curvature vectors, 1/mm</source>
        <translation>Länge der Differenz der Krümmungsvektoren, 1/mm</translation>
    </message>
    <message>
        <source>Difference of the torsions, 1/mm</source>
        <translation>Differenz der Torsionen, 1/mm</translation>
    </message>
    <message>
        <source>Difference of the rates of curvature by arc length, 1/mm²</source>
        <translation>Differenz der Krümmungsänderungen nach der Bogenlänge, 1/mm²</translation>
    </message>
    <message>
        <source>The derivative of arc length of this order at the end, by the parameter, as a share of the chord; β1 is the speed</source>
        <translation>Die Ableitung dieser Ordnung der Bogenlänge nach dem Parameter am Ende, als Anteil der Sehne; β1 ist die Geschwindigkeit</translation>
    </message>
    <message>
        <source>Whether the number is given; else it is chosen at each recompute</source>
        <translation>Ob die Zahl vorgegeben ist; sonst wird sie bei jeder Neuberechnung gewählt</translation>
    </message>
    <message>
        <source>The edge that the blend leaves</source>
        <extracomment>as stored -&gt; as osculate takes it</extracomment>
        <translation>Die Kante, von der die Überblendung ausgeht</translation>
    </message>
    <message>
        <source>Where the blend leaves the first edge</source>
        <translation>Wo die Überblendung die erste Kante verlässt</translation>
    </message>
    <message>
        <source>The place inside the first edge, as a share of its length</source>
        <translation>Die Stelle auf der ersten Kante, als Anteil ihrer Länge</translation>
    </message>
    <message>
        <source>The edge at which the blend arrives</source>
        <translation>Die Kante, an der die Überblendung ankommt</translation>
    </message>
    <message>
        <source>Where the blend arrives at the second edge</source>
        <translation>Wo die Überblendung an der zweiten Kante ankommt</translation>
    </message>
    <message>
        <source>The place inside the second edge, as a share of its length</source>
        <translation>Die Stelle auf der zweiten Kante, als Anteil ihrer Länge</translation>
    </message>
    <message>
        <source>Order of contact with the first edge, 0 to 8</source>
        <translation>Ordnung der Berührung mit der ersten Kante, 0 bis 8</translation>
    </message>
    <message>
        <source>Order of contact with the second edge, 0 to 8</source>
        <translation>Ordnung der Berührung mit der zweiten Kante, 0 bis 8</translation>
    </message>
    <message>
        <source>The degree; 0 for the least that the orders need, their sum and 1</source>
        <translation>Der Grad; 0 für den kleinsten, den die Ordnungen brauchen: ihre Summe und 1</translation>
    </message>
    <message>
        <source>What chooses the free numbers: least variation of curvature, least bending, or none (speed 1, the others 0)</source>
        <translation>Was die freien Zahlen wählt: kleinste Änderung der Krümmung, kleinste Biegung oder nichts (Geschwindigkeit 1, die anderen 0)</translation>
    </message>
    <message>
        <source>Whether chosen numbers are equal at both ends</source>
        <translation>Ob gewählte Zahlen an beiden Enden gleich sind</translation>
    </message>
    <message>
        <source>Where the blend leaves both edges, the nearest ends being found</source>
        <translation>Wo die Überblendung beide Kanten verlässt, nachdem die nächsten Enden gefunden sind</translation>
    </message>
    <message>
        <source>OK, or why there is no new result</source>
        <extracomment>Results that every such object has.</extracomment>
        <translation>OK, oder warum es kein neues Ergebnis gibt</translation>
    </message>
    <message>
        <source>G0 to G8, or gap, of each join that was made</source>
        <translation>G0 bis G8 oder gap (Lücke) für jeden Übergang, der entstand</translation>
    </message>
    <message>
        <source>Order of geometric continuity of each join, -1 for a gap</source>
        <translation>Ordnung der geometrischen Stetigkeit jedes Übergangs, -1 für eine Lücke</translation>
    </message>
    <message>
        <source>What is not as it should be, in sentences</source>
        <translation>Was nicht ist, wie es sein sollte, in Sätzen</translation>
    </message>
    <message>
        <source>The degree of the curve</source>
        <translation>Der Grad der Kurve</translation>
    </message>
    <message>
        <source>The length of the curve</source>
        <translation>Die Länge der Kurve</translation>
    </message>
    <message>
        <source>Bending energy, length times the integral of curvature squared</source>
        <translation>Biegeenergie: Länge mal Integral der quadrierten Krümmung</translation>
    </message>
    <message>
        <source>Variation of curvature: length cubed times the integral of the square of the rate of the curvature vector</source>
        <translation>Änderung der Krümmung: dritte Potenz der Länge mal Integral der quadrierten Änderung des Krümmungsvektors</translation>
    </message>
    <message>
        <source>Unevenness of the parameter&apos;s speed, 0 for an even one</source>
        <translation>Ungleichmäßigkeit der Parametergeschwindigkeit, 0 für eine gleichmäßige</translation>
    </message>
    <message>
        <source>The reports of the joins as a JSON list, schema osculate.join/1</source>
        <translation>Die Berichte der Übergänge als JSON-Liste, Schema osculate.join/1</translation>
    </message>
    <message>
        <source>The vertices that the curve runs through, in this order</source>
        <extracomment>why it failed</extracomment>
        <translation>Die Eckpunkte, durch die die Kurve läuft, in dieser Reihenfolge</translation>
    </message>
    <message>
        <source>The points that it runs through where no vertices are linked</source>
        <translation>Die Punkte, durch die sie läuft, wo keine Eckpunkte verknüpft sind</translation>
    </message>
    <message>
        <source>The tension at all points that have none of their own; 0 for the C2 cubic spline, large for a polygon with round corners</source>
        <translation>Die Spannung an allen Punkten, die keine eigene haben; 0 für den kubischen C2-Spline, groß für ein Polygon mit runden Ecken</translation>
    </message>
    <message>
        <source>The tension of each point; a negative one stands for Tension</source>
        <translation>Die Spannung jedes Punktes; eine negative steht für Tension</translation>
    </message>
    <message>
        <source>Natural ends, those of a parabola, given tangents, or a closed curve</source>
        <translation>Natürliche Enden, die einer Parabel, gegebene Tangenten oder eine geschlossene Kurve</translation>
    </message>
    <message>
        <source>The direction in which the curve begins; a unit vector has a neutral speed</source>
        <translation>Die Richtung, in der die Kurve beginnt; ein Einheitsvektor hat eine neutrale Geschwindigkeit</translation>
    </message>
    <message>
        <source>The direction in which it ends, likewise</source>
        <translation>Die Richtung, in der sie endet, ebenso</translation>
    </message>
    <message>
        <source>How the parameter&apos;s steps follow from the distances of the points</source>
        <translation>Wie die Schritte des Parameters aus den Abständen der Punkte folgen</translation>
    </message>
    <message>
        <source>The edges of the chain; the first gives the direction</source>
        <translation>Die Kanten der Kette; die erste gibt die Richtung an</translation>
    </message>
    <message>
        <source>How far the curve may leave the edges to close gaps and to have fewer knots; 0 for not at all</source>
        <translation>Wie weit die Kurve von den Kanten abweichen darf, um Lücken zu schließen und weniger Knoten zu haben; 0: gar nicht</translation>
    </message>
    <message>
        <source>How far the curve leaves the edges at most</source>
        <translation>Wie weit die Kurve höchstens von den Kanten abweicht</translation>
    </message>
    <message>
        <source>G0 to G8, or gap, of the edges at each join, as they were</source>
        <translation>G0 bis G8 oder Lücke der Kanten an jedem Übergang, wie sie waren</translation>
    </message>
    <message>
        <source>The knots of the curve</source>
        <translation>Die Knoten der Kurve</translation>
    </message>
    <message>
        <source>The multiplicities of the knots</source>
        <translation>Die Vielfachheiten der Knoten</translation>
    </message>
    <message>
        <source>How far the pole of this number lies ahead of the end along the tangent</source>
        <extracomment>Which numbers the user gives.</extracomment>
        <translation>Wie weit der Pol dieser Nummer längs der Tangente vor dem Ende liegt</translation>
    </message>
    <message>
        <source>The edge that is continued</source>
        <translation>Die Kante, die fortgesetzt wird</translation>
    </message>
    <message>
        <source>The end at which it is continued</source>
        <translation>Das Ende, an dem sie fortgesetzt wird</translation>
    </message>
    <message>
        <source>Whether the shape is a wire of the edge and its continuation, not the continuation alone</source>
        <translation>Ob die Form ein Kantenzug aus der Kante und ihrer Fortsetzung ist, nicht die Fortsetzung allein</translation>
    </message>
    <message>
        <source>Geometric: the shape goes on; parametric: its parameter too; re-parametrised: likewise, and cut at Parameter; natural: the curve itself goes on</source>
        <translation>Geometric: die Form geht weiter; parametric: auch ihr Parameter; re-parametrised: ebenso, bei Parameter abgeschnitten; natural: die Kurve selbst geht weiter</translation>
    </message>
    <message>
        <source>Order of contact with the edge, 0 to 8</source>
        <translation>Ordnung der Berührung mit der Kante, 0 bis 8</translation>
    </message>
    <message>
        <source>Which part of the parametric continuation over 0 to 1 is taken</source>
        <translation>Welcher Teil der parametrischen Fortsetzung über 0 bis 1 genommen wird</translation>
    </message>
    <message>
        <source>The degree; 0 for the least that can</source>
        <translation>Der Grad; 0 für den kleinsten, der es kann</translation>
    </message>
    <message>
        <source>The length of the continuation</source>
        <translation>Die Länge der Fortsetzung</translation>
    </message>
    <message>
        <source>Whether the length is given; else it follows from all else</source>
        <translation>Ob die Länge gegeben ist; sonst folgt sie aus allem anderen</translation>
    </message>
    <message>
        <source>What chooses the free numbers: least variation of curvature, least bending, or none (there must be no free ones)</source>
        <translation>Was die freien Zahlen wählt: kleinste Änderung der Krümmung, kleinste Biegung oder nichts (dann darf keine frei sein)</translation>
    </message>
    <message>
        <source>Which numbers are given: beta, or tangential coordinates of the poles</source>
        <translation>Welche Zahlen gegeben werden: Beta oder tangentiale Koordinaten der Pole</translation>
    </message>
    <message>
        <source>Whether the continuation ends at a vertex or a position</source>
        <translation>Ob die Fortsetzung an einem Eckpunkt oder an einer Stelle endet</translation>
    </message>
    <message>
        <source>The vertex at which it ends</source>
        <translation>Der Eckpunkt, an dem sie endet</translation>
    </message>
    <message>
        <source>The point at which it ends</source>
        <translation>Der Punkt, an dem sie endet</translation>
    </message>
    <message>
        <source>Whether it arrives there in a given direction</source>
        <translation>Ob sie dort in einer gegebenen Richtung ankommt</translation>
    </message>
    <message>
        <source>The direction of the tangent at its far end</source>
        <translation>Die Richtung der Tangente an ihrem fernen Ende</translation>
    </message>
    <message>
        <source>Whether it arrives with a given curvature, its magnitude or its vector</source>
        <translation>Ob sie mit einer gegebenen Krümmung ankommt, deren Betrag oder Vektor</translation>
    </message>
    <message>
        <source>The curvature at its far end in 1/mm, 0 for straight</source>
        <translation>Die Krümmung an ihrem fernen Ende in 1/mm, 0 für gerade</translation>
    </message>
    <message>
        <source>The curvature vector at its far end in 1/mm, towards the centre</source>
        <translation>Der Krümmungsvektor an ihrem fernen Ende in 1/mm, zum Mittelpunkt hin</translation>
    </message>
    <message>
        <source>How many numbers were left free, so that fairness chose them</source>
        <translation>Wie viele Zahlen frei blieben, sodass die Glätte sie wählte</translation>
    </message>
    <message>
        <source>The edge that stays</source>
        <extracomment>The far end is looked at up to this order, or to the order that is kept if that is higher.</extracomment>
        <translation>Die Kante, die bleibt</translation>
    </message>
    <message>
        <source>Where it is met</source>
        <translation>Wo sie getroffen wird</translation>
    </message>
    <message>
        <source>The place inside the reference, as a share of its length</source>
        <translation>Die Stelle innerhalb der Bezugskante, als Anteil ihrer Länge</translation>
    </message>
    <message>
        <source>The edge that is changed; it stays as it is, the result is another one</source>
        <translation>Die Kante, die geändert wird; sie selbst bleibt, wie sie ist, das Ergebnis ist eine andere</translation>
    </message>
    <message>
        <source>Which end of it meets the reference</source>
        <translation>Welches ihrer Enden die Bezugskante trifft</translation>
    </message>
    <message>
        <source>Whether the object of the edge as it was is hidden</source>
        <translation>Ob das Objekt der Kante, wie sie war, verborgen ist</translation>
    </message>
    <message>
        <source>Order of contact with the reference, 0 to 8</source>
        <translation>Ordnung der Berührung mit der Bezugskante, 0 bis 8</translation>
    </message>
    <message>
        <source>Up to which order the derivatives at the far end stay, 0 to 8</source>
        <translation>Bis zu welcher Ordnung die Ableitungen am fernen Ende bleiben, 0 bis 8</translation>
    </message>
    <message>
        <source>The degree; 0 for that of the edge where it suffices, else the least</source>
        <translation>Der Grad; 0 für den der Kante, wo er genügt, sonst den kleinsten</translation>
    </message>
    <message>
        <source>How many spans may change, from the join; 0 for as many as are useful</source>
        <translation>Wie viele Segmente sich vom Übergang an ändern dürfen; 0 für so viele, wie nützen</translation>
    </message>
    <message>
        <source>Which ends meet, the nearest being found</source>
        <translation>Welche Enden sich treffen, nachdem die nächsten gefunden sind</translation>
    </message>
    <message>
        <source>No point of the edge moved farther</source>
        <translation>Kein Punkt der Kante hat sich weiter bewegt</translation>
    </message>
    <message>
        <source>Root mean square of the displacement over the spans that changed</source>
        <translation>Quadratisches Mittel der Verschiebung über die geänderten Segmente</translation>
    </message>
    <message>
        <source>How many spans changed, from the join</source>
        <translation>Wie viele Segmente sich vom Übergang an geändert haben</translation>
    </message>
    <message>
        <source>The control points in the order of their indices, from (n, 0, 0, 0) to (0, 0, 0, n)</source>
        <extracomment>`check_validity`: degree 12 takes half a second.</extracomment>
        <translation>Die Kontrollpunkte in der Reihenfolge ihrer Indizes, von (n, 0, 0, 0) bis (0, 0, 0, n)</translation>
    </message>
    <message>
        <source>The weight of each control point; none where all are 1</source>
        <translation>Das Gewicht jedes Kontrollpunkts; keines, wo alle 1 sind</translation>
    </message>
    <message>
        <source>The fourth coordinate of each control point in four dimensions, in mm; none in three</source>
        <translation>Die vierte Koordinate jedes Kontrollpunkts in vier Dimensionen, in mm; keine in dreien</translation>
    </message>
    <message>
        <source>The degree, which follows from the number of points</source>
        <translation>Der Grad, der aus der Zahl der Punkte folgt</translation>
    </message>
    <message>
        <source>The volume; where the solid folds, parts covered inside out are taken off</source>
        <translation>Das Volumen; wo der Körper sich faltet, werden umgestülpte Teile abgezogen</translation>
    </message>
    <message>
        <source>The centre of mass</source>
        <translation>Der Schwerpunkt</translation>
    </message>
    <message>
        <source>valid, singular or inverted and where, undecided, or nothing where it was not checked</source>
        <translation>valid (gültig), singular oder inverted (gefaltet) und wo, undecided (unentschieden), oder nichts, wo nicht geprüft wurde</translation>
    </message>
    <message>
        <source>The Bézier solid that this one follows</source>
        <extracomment>Attribute of a property that only changes how an object looks: it is not recomputed.</extracomment>
        <translation>Der Bézier-Körper, dem dieser folgt</translation>
    </message>
    <message>
        <source>The first Bézier solid</source>
        <extracomment>that of osculate.BezierTetrahedron.contact</extracomment>
        <translation>Der erste Bézier-Körper</translation>
    </message>
    <message>
        <source>The second Bézier solid</source>
        <translation>Der zweite Bézier-Körper</translation>
    </message>
    <message>
        <source>How far control points of the shared face may be apart; those of deeper layers correspondingly more</source>
        <translation>Wie weit Kontrollpunkte der gemeinsamen Fläche auseinander liegen dürfen; die tieferer Schichten entsprechend mehr</translation>
    </message>
    <message>
        <source>C0, C1, … or none where no faces meet</source>
        <translation>C0, C1, … oder none, wo keine Flächen aneinanderstoßen</translation>
    </message>
    <message>
        <source>The highest s with C^s contact of the solids in space, -1 for none</source>
        <translation>Das höchste s mit C^s-Kontakt der Körper im Raum, -1 für keinen</translation>
    </message>
    <message>
        <source>The same of points and weights together, which is sufficient but not necessary</source>
        <translation>Dasselbe für Punkte und Gewichte zusammen; das ist hinreichend, aber nicht notwendig</translation>
    </message>
    <message>
        <source>The face of the first and of the second solid that meet or come nearest, by the numbers of the opposite corners</source>
        <translation>Die Flächen des ersten und des zweiten Körpers, die aneinanderstoßen oder sich am nächsten kommen, nach den Nummern der gegenüberliegenden Ecken</translation>
    </message>
    <message>
        <source>The largest distance of corresponding points of the two faces</source>
        <translation>Der größte Abstand entsprechender Punkte der beiden Flächen</translation>
    </message>
    <message>
        <source>For each order from 0 the largest difference, as a displacement of control points in mm</source>
        <translation>Für jede Ordnung ab 0 der größte Unterschied, als Verschiebung von Kontrollpunkten in mm</translation>
    </message>
    <message>
        <source>The same of points and weights together</source>
        <translation>Dasselbe für Punkte und Gewichte zusammen</translation>
    </message>
    <message>
        <source>Whether both solids lie on the same side of the face</source>
        <translation>Ob beide Körper auf derselben Seite der Fläche liegen</translation>
    </message>
    <message>
        <source>The colour of the faces</source>
        <extracomment>Choices of SliceDirection: barycentric coordinates, then planes across an axis.</extracomment>
        <translation>Die Farbe der Flächen</translation>
    </message>
    <message>
        <source>How transparent the faces are, in percent</source>
        <translation>Wie durchsichtig die Flächen sind, in Prozent</translation>
    </message>
    <message>
        <source>The colour of the edges</source>
        <translation>Die Farbe der Kanten</translation>
    </message>
    <message>
        <source>The width of the edges in pixels</source>
        <translation>Die Breite der Kanten in Pixeln</translation>
    </message>
    <message>
        <source>The largest distance of the drawn triangles from the faces; 0 for a thousandth of the solid&apos;s size</source>
        <translation>Der größte Abstand der gezeichneten Dreiecke von den Flächen; 0 für ein Tausendstel der Größe des Körpers</translation>
    </message>
    <message>
        <source>Whether the faces and slices are coloured by the Jacobian determinant: blue where it is &gt; 0, orange where the solid folds</source>
        <translation>Ob Flächen und Schnitte nach der Jacobi-Determinante gefärbt sind: blau, wo sie &gt; 0 ist, orange, wo der Körper sich faltet</translation>
    </message>
    <message>
        <source>Whether the control net is drawn</source>
        <translation>Ob das Kontrollnetz gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether the control points are labelled with their indices</source>
        <translation>Ob die Kontrollpunkte mit ihren Indizes beschriftet sind</translation>
    </message>
    <message>
        <source>Whether the control points are labelled with their weights</source>
        <translation>Ob die Kontrollpunkte mit ihren Gewichten beschriftet sind</translation>
    </message>
    <message>
        <source>The colour of the control net</source>
        <translation>Die Farbe des Kontrollnetzes</translation>
    </message>
    <message>
        <source>The size of the control points in pixels</source>
        <translation>Die Größe der Kontrollpunkte in Pixeln</translation>
    </message>
    <message>
        <source>Whether the interior is shown by slices; the faces are drawn transparent then</source>
        <translation>Ob das Innere durch Schnitte gezeigt wird; die Flächen sind dann durchsichtig</translation>
    </message>
    <message>
        <source>The number of slices, evenly spaced</source>
        <translation>Die Zahl der Schnitte, in gleichen Abständen</translation>
    </message>
    <message>
        <source>What is constant on a slice: the barycentric coordinate of a corner, or a coordinate in space</source>
        <translation>Was auf einem Schnitt gleich bleibt: die baryzentrische Koordinate einer Ecke oder eine Koordinate im Raum</translation>
    </message>
    <message>
        <source>What the teeth show: curvature, torsion, or a rate by arc length</source>
        <translation>Was die Zinken zeigen: Krümmung, Torsion oder eine Änderung nach der Bogenlänge</translation>
    </message>
    <message>
        <source>Teeth of each Bézier segment</source>
        <translation>Zinken je Bézier-Segment</translation>
    </message>
    <message>
        <source>Whether the length of the teeth suits the size of the curves</source>
        <translation>Ob die Länge der Zinken der Größe der Kurven folgt</translation>
    </message>
    <message>
        <source>Length of a tooth in mm for a value of 1, where it is not automatic</source>
        <translation>Länge einer Zinke in mm für den Wert 1, wo sie nicht selbsttätig gewählt wird</translation>
    </message>
    <message>
        <source>Makes the teeth longer or shorter than the automatic scale does</source>
        <translation>Macht die Zinken länger oder kürzer als der selbsttätige Maßstab</translation>
    </message>
    <message>
        <source>Whether the teeth are drawn</source>
        <translation>Ob die Zinken gezeichnet werden</translation>
    </message>
    <message>
        <source>Whether the line over the teeth is drawn</source>
        <translation>Ob die Linie über den Zinken gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether peaks, inflections, vertices and cusps are marked</source>
        <translation>Ob Spitzenwerte, Wendepunkte, Scheitel und Kurvenspitzen markiert werden</translation>
    </message>
    <message>
        <source>Whether the view explains the comb</source>
        <translation>Ob die Ansicht den Kamm erklärt</translation>
    </message>
    <message>
        <source>Number of edges</source>
        <translation>Zahl der Kanten</translation>
    </message>
    <message>
        <source>Length of all edges</source>
        <translation>Länge aller Kanten</translation>
    </message>
    <message>
        <source>Largest curvature, 1/mm</source>
        <translation>Größte Krümmung, 1/mm</translation>
    </message>
    <message>
        <source>Smallest radius of curvature; 0 where nothing bends</source>
        <translation>Kleinster Krümmungsradius; 0, wo nichts gekrümmt ist</translation>
    </message>
    <message>
        <source>Largest magnitude of the torsion, 1/mm</source>
        <translation>Größter Betrag der Torsion, 1/mm</translation>
    </message>
    <message>
        <source>Number of inflections</source>
        <translation>Zahl der Wendepunkte</translation>
    </message>
    <message>
        <source>Number of vertices: points where the curvature is stationary</source>
        <translation>Zahl der Scheitel: Punkte, an denen die Krümmung stationär ist</translation>
    </message>
    <message>
        <source>Number of cusps</source>
        <translation>Zahl der Kurvenspitzen</translation>
    </message>
    <message>
        <source>Edges, faces, or whole objects, all of whose edges count</source>
        <translation>Kanten, Flächen oder ganze Objekte, deren Kanten alle zählen</translation>
    </message>
    <message>
        <source>What is left out, in sentences</source>
        <translation>Was ausgelassen ist, in Sätzen</translation>
    </message>
    <message>
        <source>Whether the weights of rational segments stand at their poles</source>
        <extracomment>[0, 1], shortened to a part of the size of the curves.</extracomment>
        <translation>Ob die Gewichte rationaler Segmente an ihren Polen stehen</translation>
    </message>
    <message>
        <source>Whether the first differences Δb of the poles are drawn as arrows</source>
        <translation>Ob die ersten Differenzen Δb der Kontrollpunkte als Pfeile gezeichnet werden</translation>
    </message>
    <message>
        <source>Whether the second differences Δ²b of the poles are drawn as arrows</source>
        <translation>Ob die zweiten Differenzen Δ²b der Kontrollpunkte als Pfeile gezeichnet werden</translation>
    </message>
    <message>
        <source>Whether differences are drawn as they are, or as poles of derivatives</source>
        <translation>Ob Differenzen gezeichnet werden, wie sie sind, oder als Kontrollpunkte der Ableitungen</translation>
    </message>
    <message>
        <source>Whether the view explains what is drawn</source>
        <translation>Ob die Ansicht erklärt, was gezeichnet ist</translation>
    </message>
    <message>
        <source>Number of Bézier segments</source>
        <translation>Anzahl der Bézier-Segmente</translation>
    </message>
    <message>
        <source>Number of those that are rational</source>
        <translation>Anzahl der rationalen darunter</translation>
    </message>
    <message>
        <source>The degrees of the segments, each once</source>
        <translation>Die Grade der Segmente, jeder einmal</translation>
    </message>
    <message>
        <source>Number of poles of all segments</source>
        <translation>Anzahl der Kontrollpunkte aller Segmente</translation>
    </message>
    <message>
        <source>Where the point is, as a share of the length of all edges, 0 to 1</source>
        <extracomment>What can be drawn at the point: the name of its property.</extracomment>
        <translation>Wo der Punkt ist, als Anteil der Länge aller Kanten, 0 bis 1</translation>
    </message>
    <message>
        <source>Whether tangent, normal and binormal are drawn</source>
        <translation>Ob Tangente, Normale und Binormale gezeichnet werden</translation>
    </message>
    <message>
        <source>Whether the osculating circle and its centre are drawn</source>
        <translation>Ob der Krümmungskreis und sein Mittelpunkt gezeichnet werden</translation>
    </message>
    <message>
        <source>Whether the plane of tangent and normal is drawn</source>
        <translation>Ob die Ebene von Tangente und Normale gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether the plane of normal and binormal is drawn</source>
        <translation>Ob die Ebene von Normale und Binormale gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether the plane of tangent and binormal is drawn</source>
        <translation>Ob die Ebene von Tangente und Binormale gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether the construction of de Casteljau is drawn</source>
        <translation>Ob die Konstruktion von de Casteljau gezeichnet wird</translation>
    </message>
    <message>
        <source>Whether curvature, radius and torsion stand beside the point</source>
        <translation>Ob Krümmung, Radius und Torsion beim Punkt stehen</translation>
    </message>
    <message>
        <source>Where the point is, along the edges</source>
        <translation>Wo der Punkt ist, entlang der Kanten</translation>
    </message>
    <message>
        <source>The number of its edge among all of them, from 1</source>
        <translation>Die Nummer seiner Kante unter allen, ab 1</translation>
    </message>
    <message>
        <source>Where it is, as a parameter of the edge in its own direction</source>
        <translation>Wo er ist, als Parameter der Kante in ihrer eigenen Richtung</translation>
    </message>
    <message>
        <source>What is special about the point: end, join, knot, inflection, ...</source>
        <translation>Was an dem Punkt besonders ist: end, join, knot, inflection, ...</translation>
    </message>
    <message>
        <source>The point</source>
        <translation>Der Punkt</translation>
    </message>
    <message>
        <source>Tangent; zero where Missing names it</source>
        <translation>Tangente; null, wo Missing sie nennt</translation>
    </message>
    <message>
        <source>Normal, towards the centre of curvature; zero where Missing names it</source>
        <translation>Normale, zum Krümmungsmittelpunkt hin; null, wo Missing sie nennt</translation>
    </message>
    <message>
        <source>Binormal; zero where Missing names it</source>
        <translation>Binormale; null, wo Missing sie nennt</translation>
    </message>
    <message>
        <source>Curvature, 1/mm; 0 where Missing names it</source>
        <translation>Krümmung, 1/mm; 0, wo Missing sie nennt</translation>
    </message>
    <message>
        <source>Radius of curvature; 0 where Missing names it</source>
        <translation>Krümmungsradius; 0, wo Missing ihn nennt</translation>
    </message>
    <message>
        <source>Torsion, 1/mm; 0 where Missing names it</source>
        <translation>Torsion, 1/mm; 0, wo Missing sie nennt</translation>
    </message>
    <message>
        <source>Which of these do not exist at the point</source>
        <translation>Was davon es an dem Punkt nicht gibt</translation>
    </message>
    <message>
        <source>Whether joins, knots, inflections and vertices are marked</source>
        <translation>Ob Übergänge, Knoten, Wendepunkte und Scheitel markiert sind</translation>
    </message>
    <message>
        <source>The objects whose joins are audited; of each all edges count</source>
        <translation>Die Objekte, deren Übergänge geprüft werden; von jedem zählen alle Kanten</translation>
    </message>
    <message>
        <source>Matched curves that stand for the edges that they change</source>
        <translation>Angepasste Kurven, die für die Kanten stehen, die sie ändern</translation>
    </message>
    <message>
        <source>Which edges at a vertex are a join: all but corners, those that follow each other in a wire, or all</source>
        <translation>Welche Kanten an einem Eckpunkt ein Übergang sind: alle außer Ecken, solche, die in einem Kantenzug aufeinander folgen, oder alle</translation>
    </message>
    <message>
        <source>Tangents that turn by more than this are a corner</source>
        <translation>Tangenten, die sich um mehr als das drehen, sind eine Ecke</translation>
    </message>
    <message>
        <source>How far ends of edges in no wire may be apart to be a join; 0: only where they share a vertex</source>
        <translation>Wie weit die Enden von Kanten ohne Kantenzug auseinander sein dürfen, um ein Übergang zu sein; 0: nur wo sie einen Eckpunkt teilen</translation>
    </message>
    <message>
        <source>The order that joins must have; those below are out of tolerance</source>
        <translation>Die Ordnung, die Übergänge haben müssen; die darunter sind außer Toleranz</translation>
    </message>
    <message>
        <source>Which joins are drawn, in the colour of their order</source>
        <translation>Welche Übergänge gezeichnet werden, in der Farbe ihrer Ordnung</translation>
    </message>
    <message>
        <source>How many joins that are out of tolerance have a number, the worst first</source>
        <translation>Wie viele Übergänge außer Toleranz eine Nummer haben, die schlechtesten zuerst</translation>
    </message>
    <message>
        <source>Whether the view explains the colours</source>
        <translation>Ob die Ansicht die Farben erklärt</translation>
    </message>
    <message>
        <source>Number of joins of this order</source>
        <translation>Zahl der Übergänge dieser Ordnung</translation>
    </message>
    <message>
        <source>Number of joins</source>
        <translation>Zahl der Übergänge</translation>
    </message>
    <message>
        <source>Number of joins below the order that they must have</source>
        <translation>Zahl der Übergänge unter der Ordnung, die sie haben müssen</translation>
    </message>
    <message>
        <source>Number of joins that are not even G0</source>
        <translation>Zahl der Übergänge, die nicht einmal G0 sind</translation>
    </message>
    <message>
        <source>Number of joins with an order that rounding leaves undecided</source>
        <translation>Zahl der Übergänge mit einer Ordnung, die die Rundung offen lässt</translation>
    </message>
    <message>
        <source>Number of pairs of edges that were left out as corners</source>
        <translation>Zahl der Kantenpaare, die als Ecken ausgelassen wurden</translation>
    </message>
    <message>
        <source>Order of the worst join, -1 for a gap</source>
        <translation>Ordnung des schlechtesten Übergangs, -1 für eine Lücke</translation>
    </message>
    <message>
        <source>The worst join, and what it misses</source>
        <translation>Der schlechteste Übergang, und was er verfehlt</translation>
    </message>
    <message>
        <source>Where the worst join is</source>
        <translation>Wo der schlechteste Übergang ist</translation>
    </message>
    <message>
        <source>What was not audited, in sentences</source>
        <translation>Was nicht geprüft wurde, in Sätzen</translation>
    </message>
</context>
<context>
    <name>Osculate</name>
    <message>
        <source>No edge is linked (its object was deleted?).</source>
        <extracomment>why some edges are left out, in sentences</extracomment>
        <translation>Es ist keine Kante verknüpft (wurde ihr Objekt gelöscht?).</translation>
    </message>
    <message>
        <source>{} is linked without one edge of it.</source>
        <translation>{} ist ohne eine seiner Kanten verknüpft.</translation>
    </message>
    <message>
        <source>{} no longer exists.</source>
        <extracomment>The same departure, taken the other way.</extracomment>
        <translation>{} gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>{} is not an edge but a {}.</source>
        <translation>{} ist keine Kante, sondern: {}.</translation>
    </message>
    <message>
        <source>{} has no {}.</source>
        <translation>{} hat kein {}.</translation>
    </message>
    <message>
        <source>{} has no edges.</source>
        <translation>{} hat keine Kanten.</translation>
    </message>
    <message>
        <source>{} has no inner knot {} (it has {}).</source>
        <extracomment>Ends as the document stores them; None lets the analysis take the nearest.</extracomment>
        <translation>{} hat keinen inneren Knoten {} (nur {}).</translation>
    </message>
    <message>
        <source>{}, knot {}</source>
        <translation>{}, Knoten {}</translation>
    </message>
    <message>
        <source>{}, closing</source>
        <translation>{}, Schließung</translation>
    </message>
    <message>
        <source>Keep join check</source>
        <extracomment>its name, which documents keep</extracomment>
        <translation>Übergangsprüfung behalten</translation>
    </message>
    <message>
        <source>Copy</source>
        <extracomment>&quot;text&quot;, &quot;json&quot; or &quot;csv&quot;</extracomment>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the report as text</source>
        <translation>Den Bericht als Text kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save all joins as CSV or JSON</source>
        <translation>Alle Übergänge als CSV oder JSON speichern</translation>
    </message>
    <message>
        <source>Keep as object</source>
        <translation>Als Objekt behalten</translation>
    </message>
    <message>
        <source>Add a check of this join to the document; it follows every edit</source>
        <translation>Dem Dokument eine Prüfung dieses Übergangs hinzufügen; sie folgt jeder Änderung</translation>
    </message>
    <message>
        <source>Text (this join)</source>
        <translation>Text (dieser Übergang)</translation>
    </message>
    <message>
        <source>JSON (all joins)</source>
        <translation>JSON (alle Übergänge)</translation>
    </message>
    <message>
        <source>CSV (all joins)</source>
        <translation>CSV (alle Übergänge)</translation>
    </message>
    <message>
        <source>Definition</source>
        <extracomment>set where one given place is analysed instead of links</extracomment>
        <translation>Definition</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Always take the ends that lie nearest</source>
        <extracomment>a pair of ends, or None for the nearest</extracomment>
        <translation>Immer die nächstgelegenen Enden nehmen</translation>
    </message>
    <message>
        <source>Swap the edges: travel the other way</source>
        <translation>Kanten tauschen: in der anderen Richtung laufen</translation>
    </message>
    <message>
        <source>Take the other end of this edge</source>
        <translation>Das andere Ende dieser Kante nehmen</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Edit {}</source>
        <extracomment>the properties that link to them
----------
What a solid from points begins with, in mm.</extracomment>
        <translation>{} bearbeiten</translation>
    </message>
    <message>
        <source>{} has no inner joins. Hold Ctrl and select the edge that it meets.</source>
        <extracomment>whether the form offers &quot;Keep as object&quot;</extracomment>
        <translation>{} hat keine inneren Übergänge. Mit gedrückter Strg-Taste die Kante auswählen, die sie trifft.</translation>
    </message>
    <message>
        <source>Saved to {}</source>
        <translation>Gespeichert in {}</translation>
    </message>
    <message>
        <source>Save the joins</source>
        <translation>Die Übergänge speichern</translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation>{} wurde dem Dokument hinzugefügt.</translation>
    </message>
    <message>
        <source>Double-click zooms to the join</source>
        <extracomment>JoinPlace of a row that was double-clicked</extracomment>
        <translation>Doppelklick zoomt zum Übergang</translation>
    </message>
    <message>
        <source>Join</source>
        <extracomment>number of an edge, -1 or 1</extracomment>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Verfehlt</translation>
    </message>
    <message>
        <source>{} joins, worst first: {}</source>
        <translation>{} Übergänge, schlechteste zuerst: {}</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Analyze join</source>
        <translation>Übergang untersuchen</translation>
    </message>
    <message>
        <source>Follow the selection</source>
        <extracomment>the PlotCanvas, once there was something to plot</extracomment>
        <translation>Der Auswahl folgen</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Definitions of G2 and G3</source>
        <translation>Definitionen von G2 und G3</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>legs on tangent</source>
        <translation>Schenkel auf der Tangente</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>torsion</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>Preset</source>
        <extracomment>Options</extracomment>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Up to order</source>
        <translation>Bis zur Ordnung</translation>
    </message>
    <message>
        <source>G0 gap</source>
        <translation>G0 Lücke</translation>
    </message>
    <message>
        <source>G1 angle</source>
        <translation>G1 Winkel</translation>
    </message>
    <message>
        <source>G2 relative</source>
        <translation>G2 relativ</translation>
    </message>
    <message>
        <source>G3 relative</source>
        <translation>G3 relativ</translation>
    </message>
    <message>
        <source>G4 and above</source>
        <translation>G4 und höher</translation>
    </message>
    <message>
        <source> From Osculate: {}.</source>
        <translation> Von Osculate: {}.</translation>
    </message>
    <message>
        <source>Your own values.</source>
        <translation>Eigene Werte.</translation>
    </message>
    <message>
        <source>tolerance {} ({})</source>
        <translation>Toleranz {} ({})</translation>
    </message>
    <message>
        <source>all orders asked for pass ({})</source>
        <translation>alle gefragten Ordnungen bestehen ({})</translation>
    </message>
    <message>
        <source>not continuous in the curves&apos; parameters</source>
        <translation>in den Parametern der Kurven nicht stetig</translation>
    </message>
    <message>
        <source>C{} in the curves&apos; own parameters</source>
        <translation>C{} in den eigenen Parametern der Kurven</translation>
    </message>
    <message>
        <source>Select two edges that meet (Ctrl adds the second), the vertex between them, or a whole wire or sketch.</source>
        <extracomment>may be, as a share of its length.</extracomment>
        <translation>Zwei Kanten auswählen, die sich treffen (die zweite mit Strg), den Punkt zwischen ihnen oder einen ganzen Kantenzug oder eine Skizze.</translation>
    </message>
    <message>
        <source>{} is no edge.</source>
        <translation>{} ist keine Kante.</translation>
    </message>
    <message>
        <source>No edge ends at {}.</source>
        <translation>Bei {} endet keine Kante.</translation>
    </message>
    <message>
        <source>pass</source>
        <extracomment>Narrower, the tables of numbers would be cut; pixels at the usual 96 dots per inch.</extracomment>
        <translation>besteht</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>verfehlt</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>not defined here</source>
        <translation>hier nicht definiert</translation>
    </message>
    <message>
        <source>gap</source>
        <extracomment>of one that was double-clicked
----------
name of an icon of resources/icons</extracomment>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>{} undecided</source>
        <translation>{} unentschieden</translation>
    </message>
    <message>
        <source>{} does not exist here</source>
        <translation>{} gibt es hier nicht</translation>
    </message>
    <message>
        <source>{} by {}</source>
        <translation>{} um {}</translation>
    </message>
    <message>
        <source>misses {} by {}</source>
        <translation>verfehlt {} um {}</translation>
    </message>
    <message>
        <source>A check must be in one document with its edges.</source>
        <translation>Eine Prüfung muss mit ihren Kanten in einem Dokument sein.</translation>
    </message>
    <message>
        <source>Select two edges.</source>
        <translation>Zwei Kanten auswählen.</translation>
    </message>
    <message>
        <source>{} depends on {}, which therefore cannot use its edges.</source>
        <extracomment>construct(obj) gives the osculate.Construction that the properties ask for</extracomment>
        <translation>{} hängt von {} ab, das deshalb seine Kanten nicht verwenden kann.</translation>
    </message>
    <message>
        <source>Fixed: click to let it be chosen</source>
        <translation>Fest: Klicken lässt sie wählen</translation>
    </message>
    <message>
        <source>Chosen by fairness: click to fix it as it is</source>
        <extracomment>as it is shown</extracomment>
        <translation>Nach Glätte gewählt: Klicken hält sie fest, wie sie ist</translation>
    </message>
    <message>
        <source>The speed at this end, as a share of the chord; it has a handle in the 3D view</source>
        <extracomment>Neither depends on the order, the degree or the other, so that a handle stays where it is put.</extracomment>
        <translation>Die Geschwindigkeit an diesem Ende, als Anteil der Sehne; sie hat einen Griff in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>The change of speed at this end, as a share of the chord; it has a handle in the 3D view</source>
        <translation>Die Änderung der Geschwindigkeit an diesem Ende, als Anteil der Sehne; sie hat einen Griff in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>The derivative of order {} of arc length at this end, as a share of the chord</source>
        <translation>Die Ableitung der Ordnung {} der Bogenlänge an diesem Ende, als Anteil der Sehne</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Chosen numbers are equal at both ends</source>
        <translation>Gewählte Zahlen sind an beiden Enden gleich</translation>
    </message>
    <message>
        <source>Fair</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Let all numbers be chosen: the fairest curve</source>
        <translation>Alle Zahlen wählen lassen: die glatteste Kurve</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>At least {}, what the orders need; further poles make the curve fairer</source>
        <translation>Mindestens {}, was die Ordnungen brauchen; weitere Pole machen die Kurve glatter</translation>
    </message>
    <message>
        <source>Even curvature</source>
        <translation>Gleichmäßige Krümmung</translation>
    </message>
    <message>
        <source>Least bending</source>
        <translation>Kleinste Biegung</translation>
    </message>
    <message>
        <source>Nothing chosen</source>
        <translation>Nichts gewählt</translation>
    </message>
    <message>
        <source>Select the two edges that the curve is to connect; the same edge twice closes it.</source>
        <translation>Wählen Sie die zwei Kanten, die die Kurve verbinden soll; zweimal dieselbe Kante wird geschlossen.</translation>
    </message>
    <message>
        <source>Take the last step back</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>Take the step again</source>
        <translation>Den Schritt wiederholen</translation>
    </message>
    <message>
        <source>These are {} edges.</source>
        <translation>Das sind {} Kanten.</translation>
    </message>
    <message>
        <source>The edges must be in one document, {}.</source>
        <extracomment>what happens now is done here</extracomment>
        <translation>Die Kanten müssen in einem Dokument liegen, {}.</translation>
    </message>
    <message>
        <source>There is nothing to keep yet: mend what is wrong, or Cancel.</source>
        <extracomment>whether the solid that it starts from is hidden</extracomment>
        <translation>Es gibt noch nichts zu behalten: beheben Sie, was nicht stimmt, oder brechen Sie ab.</translation>
    </message>
    <message>
        <source>Take the other end, or the other direction</source>
        <extracomment>of departure.CHOICES</extracomment>
        <translation>Das andere Ende nehmen, oder die andere Richtung</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>The end that lies nearest</source>
        <translation>Das Ende, das am nächsten liegt</translation>
    </message>
    <message>
        <source>The start of the edge</source>
        <translation>Der Anfang der Kante</translation>
    </message>
    <message>
        <source>The end of the edge</source>
        <translation>Das Ende der Kante</translation>
    </message>
    <message>
        <source>Inside, along the edge</source>
        <translation>Innen, entlang der Kante</translation>
    </message>
    <message>
        <source>Inside, against the edge</source>
        <translation>Innen, gegen die Kante</translation>
    </message>
    <message>
        <source>Pick an edge in the 3D view or in the tree</source>
        <extracomment>which one is at the mouse</extracomment>
        <translation>Eine Kante in der 3D-Ansicht oder im Baum wählen</translation>
    </message>
    <message>
        <source>pick an edge</source>
        <translation>Kante wählen</translation>
    </message>
    <message>
        <source>no edge</source>
        <translation>keine Kante</translation>
    </message>
    <message>
        <source>Energy</source>
        <extracomment>as ConstructForm.edited</extracomment>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>variation of curvature</source>
        <translation>Krümmungsänderung</translation>
    </message>
    <message>
        <source>bending</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>unevenness</source>
        <translation>Ungleichmäßigkeit</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Deviations at the joins</source>
        <translation>Abweichungen an den Übergängen</translation>
    </message>
    <message>
        <source>Higher orders</source>
        <extracomment>as ConstructForm.edited</extracomment>
        <translation>Höhere Ordnungen</translation>
    </message>
    <message>
        <source>Meets the edge</source>
        <translation>Trifft die Kante</translation>
    </message>
    <message>
        <source>Has its tangent</source>
        <translation>Hat ihre Tangente</translation>
    </message>
    <message>
        <source>Has its curvature</source>
        <translation>Hat ihre Krümmung</translation>
    </message>
    <message>
        <source>Has its rate of curvature and torsion</source>
        <translation>Hat ihre Krümmungsänderung und Torsion</translation>
    </message>
    <message>
        <source>Has its second rate of curvature and rate of torsion</source>
        <translation>Hat ihre zweite Krümmungsänderung und Torsionsänderung</translation>
    </message>
    <message>
        <source>Place on the edge</source>
        <extracomment>the slider was let go</extracomment>
        <translation>Stelle auf der Kante</translation>
    </message>
    <message>
        <source>No vertex is linked (its object was deleted?).</source>
        <translation>Kein Eckpunkt ist verknüpft (wurde sein Objekt gelöscht?).</translation>
    </message>
    <message>
        <source>{} is linked without one vertex of it.</source>
        <translation>{} ist ohne einen seiner Eckpunkte verknüpft.</translation>
    </message>
    <message>
        <source>{} is not a vertex but a {}.</source>
        <translation>{} ist kein Eckpunkt, sondern: {}.</translation>
    </message>
    <message>
        <source>No edges are linked.</source>
        <translation>Keine Kanten sind verknüpft.</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Was</source>
        <translation>War</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>The continuity of the edge with the next one</source>
        <translation>Die Stetigkeit der Kante mit der nächsten</translation>
    </message>
    <message>
        <source>The continuity of the joined curve there</source>
        <translation>Die Stetigkeit der verbundenen Kurve dort</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <extracomment>number of a point, -1 or 1</extracomment>
        <translation>Interpolieren</translation>
    </message>
    <message>
        <source>Pick vertices: each click adds one or takes it out</source>
        <translation>Eckpunkte auswählen: jeder Klick nimmt einen hinzu oder heraus</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Of all points without their own: 0 is the smoothest curve, a large one nearly a polygon</source>
        <translation>Aller Punkte ohne eigene: 0 ist die glatteste Kurve, eine große fast ein Polygon</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Markiert</translation>
    </message>
    <message>
        <source>The tension of the marked point</source>
        <translation>Die Spannung des markierten Punktes</translation>
    </message>
    <message>
        <source>How the parameter&apos;s steps follow from the distances of the points</source>
        <translation>Wie die Schritte des Parameters aus den Abständen der Punkte folgen</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erstes</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letztes</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Natürlich</translation>
    </message>
    <message>
        <source>As a parabola</source>
        <translation>Wie eine Parabel</translation>
    </message>
    <message>
        <source>Given directions</source>
        <translation>Gegebene Richtungen</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Centripetal</source>
        <translation>Zentripetal</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Nach Abstand</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Select the vertices that the curve is to run through, or an object for all its vertices; one that is selected again is taken out. Or add points by their coordinates with ＋.</source>
        <translation>Die Eckpunkte auswählen, durch die die Kurve laufen soll, oder ein Objekt für alle seine Eckpunkte; ein nochmals ausgewählter kommt heraus. Oder mit ＋ Punkte durch ihre Koordinaten hinzufügen.</translation>
    </message>
    <message>
        <source>At least two points are needed.</source>
        <translation>Mindestens zwei Punkte sind nötig.</translation>
    </message>
    <message>
        <source>Pick edges: each click adds one or takes it out</source>
        <translation>Kanten auswählen: jeder Klick nimmt eine hinzu oder heraus</translation>
    </message>
    <message>
        <source>How far the curve may leave the edges to close gaps and to have fewer knots; 0: not at all</source>
        <translation>Wie weit die Kurve von den Kanten abweichen darf, um Lücken zu schließen und weniger Knoten zu haben; 0: gar nicht</translation>
    </message>
    <message>
        <source>inner knots of multiplicity {}</source>
        <translation>innere Knoten der Vielfachheit {}</translation>
    </message>
    <message>
        <source>no inner knots</source>
        <translation>keine inneren Knoten</translation>
    </message>
    <message>
        <source>periodic</source>
        <translation>periodisch</translation>
    </message>
    <message>
        <source>Degree {}</source>
        <translation>Grad {}</translation>
    </message>
    <message>
        <source>{} spans</source>
        <translation>{} Abschnitte</translation>
    </message>
    <message>
        <source>It leaves the edges by at most {}.</source>
        <translation>Sie weicht um höchstens {} von den Kanten ab.</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>Select the edges of a chain, or a whole wire or sketch; an edge that is selected again is taken out.</source>
        <translation>Die Kanten einer Kette oder einen ganzen Kantenzug oder eine Skizze auswählen; eine nochmals ausgewählte Kante kommt heraus.</translation>
    </message>
    <message>
        <source>At least two edges are joined.</source>
        <translation>Mindestens zwei Kanten werden verbunden.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Move the marked row up</source>
        <extracomment>number of a row, -1 or 1</extracomment>
        <translation>Die markierte Zeile nach oben</translation>
    </message>
    <message>
        <source>Move the marked row down</source>
        <translation>Die markierte Zeile nach unten</translation>
    </message>
    <message>
        <source>Take the marked rows out</source>
        <translation>Die markierten Zeilen herausnehmen</translation>
    </message>
    <message>
        <source>Add a point by its coordinates</source>
        <translation>Einen Punkt durch seine Koordinaten hinzufügen</translation>
    </message>
    <message>
        <source>That of all points: click to give the point its own</source>
        <translation>Die aller Punkte: klicken, um dem Punkt eine eigene zu geben</translation>
    </message>
    <message>
        <source>{} is no vertex.</source>
        <translation>{} ist kein Eckpunkt.</translation>
    </message>
    <message>
        <source>least ({})</source>
        <translation>min. ({})</translation>
    </message>
    <message>
        <source>Extend</source>
        <translation>Verlängern</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>{} ({} free)</source>
        <translation>{} ({} frei)</translation>
    </message>
    <message>
        <source>Nothing fixes {} numbers; fairness chose them</source>
        <translation>Nichts hält {} Zahlen fest; die Glätte wählte sie</translation>
    </message>
    <message>
        <source>Together with the edge</source>
        <translation>Zusammen mit der Kante</translation>
    </message>
    <message>
        <source>One wire of the edge and its continuation, as a sweep takes it</source>
        <translation>Ein Kantenzug aus der Kante und ihrer Fortsetzung, wie ein Sweep ihn nimmt</translation>
    </message>
    <message>
        <source>given as</source>
        <translation>gegeben als</translation>
    </message>
    <message>
        <source>The shape goes on (G)</source>
        <translation>Die Form geht weiter (G)</translation>
    </message>
    <message>
        <source>The parameter goes on too (C)</source>
        <translation>Auch der Parameter geht weiter (C)</translation>
    </message>
    <message>
        <source>Likewise, up to a parameter</source>
        <translation>Ebenso, bis zu einem Parameter</translation>
    </message>
    <message>
        <source>The curve itself goes on</source>
        <translation>Die Kurve selbst geht weiter</translation>
    </message>
    <message>
        <source>Geometric continuity of the order chosen; all numbers are free</source>
        <translation>Geometrische Stetigkeit der gewählten Ordnung; alle Zahlen sind frei</translation>
    </message>
    <message>
        <source>Derivatives by the edge&apos;s own parameter, up to the order chosen</source>
        <translation>Ableitungen nach dem Parameter der Kante, bis zur gewählten Ordnung</translation>
    </message>
    <message>
        <source>Of the parametric continuation over 0 to 1 the part up to a parameter, by de Casteljau</source>
        <translation>Von der parametrischen Fortsetzung über 0 bis 1 der Teil bis zu einem Parameter, nach de Casteljau</translation>
    </message>
    <message>
        <source>The same polynomial or rational curve beyond its end: a circle stays this circle</source>
        <translation>Dieselbe polynomiale oder rationale Kurve über ihr Ende hinaus: ein Kreis bleibt dieser Kreis</translation>
    </message>
    <message>
        <source>β, speeds as shares of the chord</source>
        <translation>β, Geschwindigkeiten als Anteile der Sehne</translation>
    </message>
    <message>
        <source>C, tangential coordinates of poles</source>
        <translation>C, tangentiale Koordinaten der Pole</translation>
    </message>
    <message>
        <source>Select the edge that is to go on, near the end where it does, or the vertex there.</source>
        <translation>Wählen Sie die Kante, die weitergehen soll, nahe dem Ende, an dem sie es tut, oder den Eckpunkt dort.</translation>
    </message>
    <message>
        <source>The vertex must be in the same document.</source>
        <translation>Der Eckpunkt muss im selben Dokument sein.</translation>
    </message>
    <message>
        <source>Click a vertex, which is followed, or a place on an edge or a face.</source>
        <translation>Klicken Sie einen Eckpunkt an, dem gefolgt wird, oder eine Stelle auf einer Kante oder Fläche.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>The length of the curve that is made</source>
        <translation>Die Länge der Kurve, die entsteht</translation>
    </message>
    <message>
        <source>Follows from all else: click to fix it as it is</source>
        <extracomment>mm, in the middle of the slider</extracomment>
        <translation>Folgt aus allem anderen: Klicken hält sie fest, wie sie ist</translation>
    </message>
    <message>
        <source>How far pole {} lies ahead of the end along the tangent</source>
        <translation>Wie weit Pol {} längs der Tangente vor dem Ende liegt</translation>
    </message>
    <message>
        <source>Up to</source>
        <extracomment>mm, at the right end of the slider</extracomment>
        <translation>Bis zu</translation>
    </message>
    <message>
        <source>Which part of the parametric continuation over 0 to 1 is taken; more than 1 lets it go on</source>
        <translation>Welcher Teil der parametrischen Fortsetzung über 0 bis 1 genommen wird; mehr als 1 lässt sie weitergehen</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>It meets the reference already</source>
        <translation>Sie trifft die Bezugskante schon</translation>
    </message>
    <message>
        <source>No point moves farther than {}</source>
        <translation>Kein Punkt bewegt sich weiter als {}</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>changes</source>
        <translation>ändert sich</translation>
    </message>
    <message>
        <source>Swap the edges: the other one is changed</source>
        <translation>Kanten vertauschen: die andere wird geändert</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>nach Bedarf</translation>
    </message>
    <message>
        <source>How many spans may change, from the join; more of them let each point move less</source>
        <translation>Wie viele Segmente sich vom Übergang an ändern dürfen; mehr davon lassen jeden Punkt sich weniger bewegen</translation>
    </message>
    <message>
        <source>Hide the edge as it was</source>
        <translation>Die Kante, wie sie war, verbergen</translation>
    </message>
    <message>
        <source>Far end keeps</source>
        <translation>Fern bleibt</translation>
    </message>
    <message>
        <source>Up to which derivative nothing changes at the other end: contact there up to this order stays</source>
        <translation>Bis zu welcher Ableitung sich am anderen Ende nichts ändert: die Berührung dort bis zu dieser Ordnung bleibt</translation>
    </message>
    <message>
        <source>Spans</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Select the edge that stays, then the edge that is to change so that it meets the first.</source>
        <translation>Wählen Sie die Kante, die bleibt, dann die Kante, die sich so ändern soll, dass sie die erste trifft.</translation>
    </message>
    <message>
        <source>Pick a vertex, or a place on an edge or a face, in the 3D view</source>
        <extracomment>whether the next click gives the point</extracomment>
        <translation>Einen Eckpunkt oder eine Stelle auf einer Kante oder Fläche in der 3D-Ansicht wählen</translation>
    </message>
    <message>
        <source>in a direction</source>
        <translation>in einer Richtung</translation>
    </message>
    <message>
        <source>The direction of the tangent at the far end, as a vector of any length</source>
        <translation>Die Richtung der Tangente am fernen Ende, als Vektor beliebiger Länge</translation>
    </message>
    <message>
        <source>to no point</source>
        <translation>zu keinem Punkt</translation>
    </message>
    <message>
        <source>to the vertex</source>
        <translation>zum Eckpunkt</translation>
    </message>
    <message>
        <source>to the point</source>
        <translation>zum Punkt</translation>
    </message>
    <message>
        <source>of any curvature</source>
        <translation>mit beliebiger Krümmung</translation>
    </message>
    <message>
        <source>of curvature</source>
        <translation>mit Krümmung</translation>
    </message>
    <message>
        <source>of curvature vector</source>
        <translation>mit Krümmungsvektor</translation>
    </message>
    <message>
        <source>{} points are no net: degree 1 has 4, degree 2 has 10, degree 3 has 20, … degree 12 has 455.</source>
        <extracomment>What the columns of a net are called, in sentences and in tables that are pasted.</extracomment>
        <translation>{} Punkte sind kein Netz: Grad 1 hat 4, Grad 2 hat 10, Grad 3 hat 20, … Grad 12 hat 455.</translation>
    </message>
    <message>
        <source>{}: {} numbers for {} points.</source>
        <translation>{}: {} Zahlen für {} Punkte.</translation>
    </message>
    <message>
        <source>{} of point {} must be a finite number, not {}.</source>
        <translation>{} des Punkts {} muss eine endliche Zahl sein, nicht {}.</translation>
    </message>
    <message>
        <source>The weight of point {} must be 0 or more, not {:g}.</source>
        <translation>Das Gewicht des Punkts {} muss 0 oder mehr sein, nicht {:g}.</translation>
    </message>
    <message>
        <source>All weights are 0: at least one must be more.</source>
        <translation>Alle Gewichte sind 0: mindestens eines muss größer sein.</translation>
    </message>
    <message>
        <source>There is no table in the text.</source>
        <extracomment>Which columns a table without a head has, by their number.</extracomment>
        <translation>In dem Text ist keine Tabelle.</translation>
    </message>
    <message>
        <source>The first line names no columns of a net: {}. They are i j k l x y z fourth weight, x y z at least.</source>
        <translation>Die erste Zeile nennt keine Spalten eines Netzes: {}. Das sind i j k l x y z fourth weight, mindestens x y z.</translation>
    </message>
    <message>
        <source>{} numbers in a row: x y z are needed, with a weight or not, with indices i j k l in front or not.</source>
        <translation>{} Zahlen in einer Zeile: nötig sind x y z, mit oder ohne Gewicht, mit oder ohne Indizes i j k l davor.</translation>
    </message>
    <message>
        <source>Line {}: {} numbers are needed, not {}.</source>
        <translation>Zeile {}: {} Zahlen sind nötig, nicht {}.</translation>
    </message>
    <message>
        <source>Line {}: {} must be a number, not “{}”.</source>
        <translation>Zeile {}: {} muss eine Zahl sein, nicht „{}“.</translation>
    </message>
    <message>
        <source>{} is no index of degree {}: four whole numbers from 0 with the sum {}.</source>
        <translation>{} ist kein Index zum Grad {}: vier ganze Zahlen ab 0 mit der Summe {}.</translation>
    </message>
    <message>
        <source>Two rows have the index {}.</source>
        <translation>Zwei Zeilen haben den Index {}.</translation>
    </message>
    <message>
        <source>No Bézier solid is linked.</source>
        <translation>Es ist kein Bézier-Körper verknüpft.</translation>
    </message>
    <message>
        <source>{} is no Bézier solid.</source>
        <translation>{} ist kein Bézier-Körper.</translation>
    </message>
    <message>
        <source>A contact needs two different solids.</source>
        <translation>Ein Kontakt braucht zwei verschiedene Körper.</translation>
    </message>
    <message>
        <source>Export to ParaView</source>
        <translation>Nach ParaView exportieren</translation>
    </message>
    <message>
        <source>ParaView (*.vtu)</source>
        <translation>ParaView (*.vtu)</translation>
    </message>
    <message>
        <source>{} as B-Rep</source>
        <translation>{} als B-Rep</translation>
    </message>
    <message>
        <source>Attach neighbour</source>
        <translation>Nachbarn ansetzen</translation>
    </message>
    <message>
        <source>Neighbour of {}</source>
        <translation>Nachbar von {}</translation>
    </message>
    <message>
        <source>Share of the face&apos;s corner {}</source>
        <translation>Anteil der {}. Ecke der Fläche</translation>
    </message>
    <message>
        <source>Over the face</source>
        <translation>Über der Fläche</translation>
    </message>
    <message>
        <source>{}, opposite to corner {}</source>
        <translation>{}, gegenüber der Ecke {}</translation>
    </message>
    <message>
        <source>Contact C</source>
        <translation>Kontakt C</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>New corner</source>
        <translation>Neue Ecke</translation>
    </message>
    <message>
        <source>follows smoothly</source>
        <translation>folgt glatt</translation>
    </message>
    <message>
        <source>at a place</source>
        <translation>an einem Ort</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>How far the neighbour&apos;s domain reaches beyond the face, as a share of the solid&apos;s own</source>
        <translation>Wie weit der Bereich des Nachbarn über die Fläche hinausreicht, als Anteil des Bereichs des Körpers</translation>
    </message>
    <message>
        <source>&lt;b&gt;No faces meet.&lt;/b&gt; Face {} and face {} come nearest: their points are up to {} apart.</source>
        <translation>&lt;b&gt;Keine Flächen stoßen aneinander.&lt;/b&gt; Fläche {} und Fläche {} kommen sich am nächsten: ihre Punkte sind bis zu {} auseinander.</translation>
    </message>
    <message>
        <source>&lt;b&gt;C{}&lt;/b&gt;: face {} meets face {}</source>
        <translation>&lt;b&gt;C{}&lt;/b&gt;: Fläche {} stößt an Fläche {}</translation>
    </message>
    <message>
        <source>Both solids lie on the same side of it.</source>
        <translation>Beide Körper liegen auf derselben Seite davon.</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Im Raum</translation>
    </message>
    <message>
        <source>With weights</source>
        <translation>Mit Gewichten</translation>
    </message>
    <message>
        <source>Check contact</source>
        <translation>Kontakt prüfen</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>Solids</source>
        <extracomment>of resources/icons, without ending</extracomment>
        <translation>Körper</translation>
    </message>
    <message>
        <source>rational</source>
        <translation>rational</translation>
    </message>
    <message>
        <source>polynomial</source>
        <translation>polynomial</translation>
    </message>
    <message>
        <source>{} points</source>
        <translation>{} Punkte</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>four dimensions</source>
        <translation>vier Dimensionen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Centroid</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>Gültigkeit</translation>
    </message>
    <message>
        <source>Raising the degree keeps the solid and gives it more points</source>
        <translation>Ein höherer Grad lässt den Körper, wie er ist, und gibt ihm mehr Punkte</translation>
    </message>
    <message>
        <source>Copy the table, for a spreadsheet</source>
        <translation>Die Tabelle kopieren, für eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Paste a table: x y z in each row, with a weight or not, with indices i j k l in front or not</source>
        <translation>Eine Tabelle einfügen: x y z in jeder Zeile, mit oder ohne Gewicht, mit oder ohne Indizes i j k l davor</translation>
    </message>
    <message>
        <source>Read a table from a text or CSV file</source>
        <translation>Eine Tabelle aus einer Text- oder CSV-Datei lesen</translation>
    </message>
    <message>
        <source>Solid from points</source>
        <translation>Körper aus Punkten</translation>
    </message>
    <message>
        <source>Raise the degree and edit the points, or paste or read a table of them.</source>
        <translation>Grad erhöhen und Punkte bearbeiten, oder eine Tabelle der Punkte einfügen oder lesen.</translation>
    </message>
    <message>
        <source>Read control points</source>
        <translation>Kontrollpunkte lesen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt *.tsv *.dat);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>“{}” is no finite number: {} of point {} stays as it was.</source>
        <extracomment>numbers of the rows that are marked</extracomment>
        <translation>„{}“ ist keine endliche Zahl: {} des Punkts {} bleibt, wie es war.</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>fourth</source>
        <translation>vierte</translation>
    </message>
    <message>
        <source>Bézier solid</source>
        <translation>Bézier-Körper</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Tetrahedron</source>
        <extracomment>from the values of the fields to one BezierTetrahedron or a list</extracomment>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Elliptic cone</source>
        <translation>Elliptischer Kegel</translation>
    </message>
    <message>
        <source>Frustum or sector of one</source>
        <translation>Kegelstumpf oder Sektor davon</translation>
    </message>
    <message>
        <source>Cylinder or sector of one</source>
        <translation>Zylinder oder Sektor davon</translation>
    </message>
    <message>
        <source>Ball octant</source>
        <translation>Kugeloktant</translation>
    </message>
    <message>
        <source>Spherical wedge</source>
        <translation>Kugelkeil</translation>
    </message>
    <message>
        <source>Wedge with circular edges</source>
        <translation>Keil mit kreisförmigen Kanten</translation>
    </message>
    <message>
        <source>Random, to learn from</source>
        <translation>Zufällig, zum Lernen</translation>
    </message>
    <message>
        <source>Corner {}</source>
        <translation>Ecke {}</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Half axis along x</source>
        <translation>Halbachse entlang x</translation>
    </message>
    <message>
        <source>Half axis along y</source>
        <translation>Halbachse entlang y</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Radius below</source>
        <translation>Radius unten</translation>
    </message>
    <message>
        <source>Radius above</source>
        <translation>Radius oben</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Direction {}</source>
        <translation>Richtung {}</translation>
    </message>
    <message>
        <source>Number of the drawing</source>
        <translation>Nummer der Ziehung</translation>
    </message>
    <message>
        <source>three dimensions</source>
        <translation>drei Dimensionen</translation>
    </message>
    <message>
        <source>The radius must be more than 0.</source>
        <translation>Der Radius muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>A direction must not be 0, 0, 0.</source>
        <translation>Eine Richtung darf nicht 0, 0, 0 sein.</translation>
    </message>
    <message>
        <source>Project from 4D</source>
        <translation>Aus 4D projizieren</translation>
    </message>
    <message>
        <source>Image of {}</source>
        <translation>Bild von {}</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>from a point</source>
        <translation>von einem Punkt aus</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>Centre in mm</source>
        <translation>Zentrum in mm</translation>
    </message>
    <message>
        <source>The image lies in the hyperplane through the origin that is perpendicular to this direction</source>
        <translation>Das Bild liegt in der Hyperebene durch den Ursprung, die senkrecht zu dieser Richtung ist</translation>
    </message>
    <message>
        <source>fourth coordinate</source>
        <translation>vierte Koordinate</translation>
    </message>
    <message>
        <source>Subdivide</source>
        <extracomment>a parameter was changed</extracomment>
        <translation>Zerlegen</translation>
    </message>
    <message>
        <source>Part of {}</source>
        <translation>Teil von {}</translation>
    </message>
    <message>
        <source>Share of corner {}</source>
        <translation>Anteil der Ecke {}</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>In</translation>
    </message>
    <message>
        <source>four, around a point</source>
        <translation>vier, um einen Punkt</translation>
    </message>
    <message>
        <source>eight, by the middles of the edges</source>
        <translation>acht, über die Mitten der Kanten</translation>
    </message>
    <message>
        <source>halves, through an edge</source>
        <translation>Hälften, durch eine Kante</translation>
    </message>
    <message>
        <source>Shares of the corners</source>
        <translation>Anteile der Ecken</translation>
    </message>
    <message>
        <source>Edge between corners</source>
        <translation>Kante zwischen den Ecken</translation>
    </message>
    <message>
        <source>Shares must be 0 or more, at least one of them more.</source>
        <translation>Anteile müssen 0 oder mehr sein, mindestens einer mehr.</translation>
    </message>
    <message>
        <source>Check validity</source>
        <translation>Gültigkeit prüfen</translation>
    </message>
    <message>
        <source>in space at {} mm</source>
        <translation>im Raum bei {} mm</translation>
    </message>
    <message>
        <source>Its corners turn the other way; exchange two of them.</source>
        <translation>Seine Ecken laufen andersherum; zwei davon vertauschen.</translation>
    </message>
    <message>
        <source>The Jacobian is positive everywhere: proved, not sampled.</source>
        <translation>Die Jacobi-Determinante ist überall positiv: bewiesen, nicht abgetastet.</translation>
    </message>
    <message>
        <source>The Jacobian is nowhere negative, and 0 there.</source>
        <translation>Die Jacobi-Determinante ist nirgends negativ und dort 0.</translation>
    </message>
    <message>
        <source>The Jacobian is negative there and positive elsewhere.</source>
        <translation>Die Jacobi-Determinante ist dort negativ und anderswo positiv.</translation>
    </message>
    <message>
        <source>The Jacobian comes so near to 0 there that the work allowed did not decide.</source>
        <translation>Die Jacobi-Determinante kommt dort der 0 so nahe, dass der erlaubte Aufwand nicht entschied.</translation>
    </message>
    <message>
        <source>mirror image</source>
        <translation>Spiegelbild</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>singulär</translation>
    </message>
    <message>
        <source>folds over itself</source>
        <translation>faltet sich</translation>
    </message>
    <message>
        <source>near {}</source>
        <translation>nahe {}</translation>
    </message>
    <message>
        <source>at {}</source>
        <translation>bei {}</translation>
    </message>
    <message>
        <source>and {} more</source>
        <translation>und {} weitere</translation>
    </message>
    <message>
        <source>corner {}</source>
        <translation>Ecke {}</translation>
    </message>
    <message>
        <source>edge {}</source>
        <translation>Kante {}</translation>
    </message>
    <message>
        <source>face {}</source>
        <translation>Fläche {}</translation>
    </message>
    <message>
        <source>every point</source>
        <translation>jedem Punkt</translation>
    </message>
    <message>
        <source>inside, {}</source>
        <translation>innen, {}</translation>
    </message>
    <message>
        <source>{} folds over itself: faces may pass through each other.</source>
        <translation>{} faltet sich: Flächen können einander durchdringen.</translation>
    </message>
    <message>
        <source>deviation {}</source>
        <translation>Abweichung {}</translation>
    </message>
    <message>
        <source>C{} misses by {}</source>
        <translation>C{} um {} verfehlt</translation>
    </message>
    <message>
        <source>both on the same side</source>
        <translation>beide auf derselben Seite</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Jacobian, mm³</source>
        <extracomment>The share of the largest magnitude up to which a Jacobian is 0.</extracomment>
        <translation>Jacobi-Determinante, mm³</translation>
    </message>
    <message>
        <source>folds where it is &lt; 0</source>
        <translation>gefaltet, wo sie &lt; 0 ist</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <extracomment>Text of a verdict on light and on dark widgets.</extracomment>
        <translation>Krümmungskamm</translation>
    </message>
    <message>
        <source>Take selection</source>
        <extracomment>take the selection: instead of the edges (False), or as well</extracomment>
        <translation>Auswahl nehmen</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Auswahl hinzunehmen</translation>
    </message>
    <message>
        <source>Teeth of each Bézier segment</source>
        <translation>Zinken je Bézier-Segment</translation>
    </message>
    <message>
        <source>Length of the teeth; Ctrl and the mouse wheel in the 3D view do the same</source>
        <translation>Länge der Zinken; Strg und das Mausrad in der 3D-Ansicht tun dasselbe</translation>
    </message>
    <message>
        <source>follows the curves</source>
        <translation>folgt den Kurven</translation>
    </message>
    <message>
        <source>The teeth keep their share of the size of the curves when these change</source>
        <translation>Die Zinken behalten ihren Anteil an der Größe der Kurven, wenn diese sich ändern</translation>
    </message>
    <message>
        <source>on the other side</source>
        <translation>auf der anderen Seite</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>Zinken</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>Hüllkurve</translation>
    </message>
    <message>
        <source>peaks, inflections, vertices</source>
        <translation>Spitzenwerte, Wendepunkte, Scheitel</translation>
    </message>
    <message>
        <source>legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>zero everywhere</source>
        <translation>überall null</translation>
    </message>
    <message>
        <source>largest curvature</source>
        <translation>größte Krümmung</translation>
    </message>
    <message>
        <source>smallest radius</source>
        <translation>kleinster Radius</translation>
    </message>
    <message>
        <source>largest torsion</source>
        <translation>größte Torsion</translation>
    </message>
    <message>
        <source>inflections</source>
        <translation>Wendepunkte</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>cusps</source>
        <translation>Kurvenspitzen</translation>
    </message>
    <message>
        <source>1 edge: {}</source>
        <translation>1 Kante: {}</translation>
    </message>
    <message>
        <source>{} edges: {}</source>
        <translation>{} Kanten: {}</translation>
    </message>
    <message>
        <source>Select edges, faces, sketches or whole objects, and press Take selection.</source>
        <translation>Wählen Sie Kanten, Flächen, Skizzen oder ganze Objekte und drücken Sie „Auswahl nehmen“.</translation>
    </message>
    <message>
        <source>largest {}</source>
        <translation>größter Wert {}</translation>
    </message>
    <message>
        <source>{} teeth cut</source>
        <translation>{} Zinken gekürzt</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Torsion</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>Rate of curvature</source>
        <translation>Änderung der Krümmung</translation>
    </message>
    <message>
        <source>Second rate of curvature</source>
        <translation>Zweite Änderung der Krümmung</translation>
    </message>
    <message>
        <source>Rate of torsion</source>
        <translation>Änderung der Torsion</translation>
    </message>
    <message>
        <source>inflection</source>
        <translation>Wendepunkt</translation>
    </message>
    <message>
        <source>vertex (κ stationary)</source>
        <translation>Scheitel (κ stationär)</translation>
    </message>
    <message>
        <source>cusp</source>
        <translation>Kurvenspitze</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitzenwert</translation>
    </message>
    <message>
        <source>Combs of the blend and of both edges, in one scale</source>
        <translation>Kämme des Übergangs und beider Kanten, in einem Maßstab</translation>
    </message>
    <message>
        <source>What is selected takes the place of these edges</source>
        <translation>Das Ausgewählte tritt an die Stelle dieser Kanten</translation>
    </message>
    <message>
        <source>What is selected counts as well</source>
        <translation>Das Ausgewählte zählt auch dazu</translation>
    </message>
    <message>
        <source>Control polygons</source>
        <extracomment>the arc length at the mouse, None where it left the curves</extracomment>
        <translation>Kontrollpolygone</translation>
    </message>
    <message>
        <source>weights of rational segments</source>
        <translation>Gewichte rationaler Segmente</translation>
    </message>
    <message>
        <source>first differences Δb</source>
        <translation>erste Differenzen Δb</translation>
    </message>
    <message>
        <source>second differences Δ²b</source>
        <translation>zweite Differenzen Δ²b</translation>
    </message>
    <message>
        <source>as they are</source>
        <translation>wie sie sind</translation>
    </message>
    <message>
        <source>as derivatives: n Δb, n (n−1) Δ²b</source>
        <translation>als Ableitungen: n Δb, n (n−1) Δ²b</translation>
    </message>
    <message>
        <source>As derivatives they are the poles of the derivatives of each segment of degree n over [0, 1], drawn shorter; rational segments have none</source>
        <translation>Als Ableitungen sind sie die Kontrollpunkte der Ableitungen jedes Segments vom Grad n über [0, 1], verkürzt gezeichnet; rationale Segmente haben keine</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>degree {}, {}</source>
        <translation>Grad {}, {}</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>poles</source>
        <translation>Kontrollpunkte</translation>
    </message>
    <message>
        <source>end of a segment</source>
        <translation>Ende eines Segments</translation>
    </message>
    <message>
        <source>inner pole</source>
        <translation>innerer Kontrollpunkt</translation>
    </message>
    <message>
        <source>all weights are 1</source>
        <translation>alle Gewichte sind 1</translation>
    </message>
    <message>
        <source>{} weights not shown</source>
        <translation>{} Gewichte nicht gezeigt</translation>
    </message>
    <message>
        <source>1 segment, degree {}</source>
        <translation>1 Segment, Grad {}</translation>
    </message>
    <message>
        <source>{} segments, degree {}</source>
        <translation>{} Segmente, Grad {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie sie ist</translation>
    </message>
    <message>
        <source>none of {} rational segments</source>
        <translation>keine von {} rationalen Segmenten</translation>
    </message>
    <message>
        <source>Curve plot</source>
        <extracomment>the user chose the scale of the values</extracomment>
        <translation>Kurvenverlauf</translation>
    </message>
    <message>
        <source>The edges must be in one document.</source>
        <extracomment>the cursor stays where it is</extracomment>
        <translation>Die Kanten müssen in einem Dokument liegen.</translation>
    </message>
    <message>
        <source>Save the plot</source>
        <translation>Den Verlauf speichern</translation>
    </message>
    <message>
        <source>Select edges, faces, sketches or whole objects to plot them.</source>
        <translation>Kanten, Flächen, Skizzen oder ganze Objekte auswählen, um ihren Verlauf zu sehen.</translation>
    </message>
    <message>
        <source>Lock scale</source>
        <translation>Maßstab festhalten</translation>
    </message>
    <message>
        <source>Keeps the scale of the values. Ctrl and the mouse wheel change it</source>
        <translation>Behält den Maßstab der Werte bei. Strg und das Mausrad ändern ihn</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Shows the whole length, as a double-click does. The mouse wheel zooms, dragging moves</source>
        <translation>Zeigt die ganze Länge, wie ein Doppelklick. Das Mausrad vergrößert, Ziehen verschiebt</translation>
    </message>
    <message>
        <source>Save the plot as SVG, PDF or PNG, or its values as CSV</source>
        <translation>Den Verlauf als SVG, PDF oder PNG speichern, oder seine Werte als CSV</translation>
    </message>
    <message>
        <source>Move the mouse along the curve, here or in the 3D view.</source>
        <translation>Die Maus entlang der Kurve führen, hier oder in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Only {} of {} edges are plotted.</source>
        <extracomment>why something is not plotted, in sentences</extracomment>
        <translation>Nur {} von {} Kanten sind gezeichnet.</translation>
    </message>
    <message>
        <source>cut, up to {}</source>
        <translation>abgeschnitten, bis {}</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>osculating plane</source>
        <extracomment>(name, text), or None</extracomment>
        <translation>Schmiegebene</translation>
    </message>
    <message>
        <source>normal plane</source>
        <translation>Normalebene</translation>
    </message>
    <message>
        <source>rectifying plane</source>
        <translation>rektifiz. Ebene</translation>
    </message>
    <message>
        <source>Probe</source>
        <extracomment>the next special point (True), or that before</extracomment>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Arc length from the start of the edges</source>
        <translation>Bogenlänge vom Anfang der Kanten</translation>
    </message>
    <message>
        <source>The parameter of the edge, in its own direction</source>
        <translation>Der Parameter der Kante, in ihrer eigenen Richtung</translation>
    </message>
    <message>
        <source>To the special point before</source>
        <translation>Zum besonderen Punkt davor</translation>
    </message>
    <message>
        <source>To the next special point</source>
        <translation>Zum nächsten besonderen Punkt</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>The mouse takes the point to ends, joins, knots, inflections and vertices that are near; Shift does the opposite</source>
        <translation>Die Maus bringt den Punkt zu nahen Enden, Übergängen, Knoten, Wendepunkten und Scheiteln; Umschalt bewirkt das Gegenteil</translation>
    </message>
    <message>
        <source>Follow the mouse</source>
        <translation>Der Maus folgen</translation>
    </message>
    <message>
        <source>The point follows the mouse along the edges until a click; without this it is dragged, or brought by a double-click</source>
        <translation>Der Punkt folgt der Maus entlang der Kanten bis zu einem Klick; sonst wird er gezogen oder mit einem Doppelklick geholt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Arc length</source>
        <translation>Bogenlänge</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Special</source>
        <translation>Besonderes</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>frame t, n, b</source>
        <translation>Dreibein t, n, b</translation>
    </message>
    <message>
        <source>osculating circle</source>
        <translation>Krümmungskreis</translation>
    </message>
    <message>
        <source>de Casteljau</source>
        <translation>de Casteljau</translation>
    </message>
    <message>
        <source>values at the point</source>
        <translation>Werte beim Punkt</translation>
    </message>
    <message>
        <source>special points</source>
        <translation>besondere Punkte</translation>
    </message>
    <message>
        <source>on edge {}</source>
        <translation>auf Kante {}</translation>
    </message>
    <message>
        <source>before</source>
        <translation>davor</translation>
    </message>
    <message>
        <source>after</source>
        <translation>danach</translation>
    </message>
    <message>
        <source>at: {}</source>
        <translation>hier: {}</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>binormal</source>
        <translation>Binormale</translation>
    </message>
    <message>
        <source>osculating circle, R {}</source>
        <translation>Krümmungskreis, R {}</translation>
    </message>
    <message>
        <source>its centre is far away</source>
        <translation>sein Mittelpunkt ist weit weg</translation>
    </message>
    <message>
        <source>no construction: the segment is a point</source>
        <translation>keine Konstruktion: das Segment ist ein Punkt</translation>
    </message>
    <message>
        <source>de Casteljau, t = {} on the segment</source>
        <translation>de Casteljau, t = {} auf dem Segment</translation>
    </message>
    <message>
        <source>control polygon, degree {}</source>
        <translation>Kontrollpolygon, Grad {}</translation>
    </message>
    <message>
        <source>level {}</source>
        <translation>Stufe {}</translation>
    </message>
    <message>
        <source>level {}: the point</source>
        <translation>Stufe {}: der Punkt</translation>
    </message>
    <message>
        <source>join</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>closing join</source>
        <translation>Schlussübergang</translation>
    </message>
    <message>
        <source>knot</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>no curvature: the speed is zero here</source>
        <translation>keine Krümmung: die Geschwindigkeit ist hier null</translation>
    </message>
    <message>
        <source>straight: no normal, no circle, no torsion</source>
        <translation>gerade: keine Normale, kein Kreis, keine Torsion</translation>
    </message>
    <message>
        <source>κ = 0: no normal, no circle, no torsion</source>
        <translation>κ = 0: keine Normale, kein Kreis, keine Torsion</translation>
    </message>
    <message>
        <source>no torsion</source>
        <translation>keine Torsion</translation>
    </message>
    <message>
        <source>before: {}</source>
        <translation>davor: {}</translation>
    </message>
    <message>
        <source>after: {}</source>
        <translation>danach: {}</translation>
    </message>
    <message>
        <source>{} exists; name it with its ending to replace it.</source>
        <translation>{} ist schon da; mit seiner Endung benannt wird es ersetzt.</translation>
    </message>
    <message>
        <source>Auditing {}…</source>
        <extracomment>by the user, the last recompute</extracomment>
        <translation>{} wird geprüft …</translation>
    </message>
    <message>
        <source>The audit was stopped. A recompute begins it again.</source>
        <translation>Die Prüfung wurde angehalten. Neuberechnen beginnt sie wieder.</translation>
    </message>
    <message>
        <source>{} bounds a face of {}: the curve that the face was made from has to change.</source>
        <translation>{} begrenzt eine Fläche von {}: Die Kurve, aus der die Fläche entstand, muss sich ändern.</translation>
    </message>
    <message>
        <source>{} was left out: {}</source>
        <translation>{} wurde ausgelassen: {}</translation>
    </message>
    <message>
        <source>{} more edges were left out.</source>
        <translation>{} weitere Kanten wurden ausgelassen.</translation>
    </message>
    <message>
        <source>Joins are analysed up to G{} only, which does not tell whether they have G{}.</source>
        <translation>Übergänge werden nur bis G{} untersucht, was nicht sagt, ob sie G{} haben.</translation>
    </message>
    <message>
        <source>There is nothing to audit (was its object deleted?).</source>
        <translation>Es gibt nichts zu prüfen (wurde das Objekt gelöscht?).</translation>
    </message>
    <message>
        <source>{}, knot at {}</source>
        <translation>{}, Knoten bei {}</translation>
    </message>
    <message>
        <source>Edges of {} bound faces: no other curve can stand for them.</source>
        <translation>Kanten von {} begrenzen Flächen: Keine andere Kurve kann für sie stehen.</translation>
    </message>
    <message>
        <source>{} is only a part of an object; an audit takes whole ones.</source>
        <translation>{} ist nur ein Teil eines Objekts; eine Prüfung nimmt ganze.</translation>
    </message>
    <message>
        <source>Audit</source>
        <extracomment>&quot;csv&quot;, &quot;json&quot; or &quot;html&quot;</extracomment>
        <translation>Prüfung aller Übergänge</translation>
    </message>
    <message>
        <source>Audit what is selected, instead</source>
        <translation>Stattdessen prüfen, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Audit what is selected, as well</source>
        <translation>Auch prüfen, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Go to each join that is clicked; a double-click always does</source>
        <translation>Zu jedem Übergang gehen, der angeklickt wird; ein Doppelklick tut es immer</translation>
    </message>
    <message>
        <source>Match…</source>
        <translation>Anpassen …</translation>
    </message>
    <message>
        <source>Save all joins as CSV</source>
        <translation>Alle Übergänge als CSV speichern</translation>
    </message>
    <message>
        <source>Save all joins as JSON</source>
        <translation>Alle Übergänge als JSON speichern</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Save a page with pictures of the worst joins, to read in a browser</source>
        <translation>Eine Seite mit Bildern der schlechtesten Übergänge speichern, zum Lesen im Browser</translation>
    </message>
    <message>
        <source>with the 3D view as it is</source>
        <translation>mit der 3D-Ansicht, wie sie ist</translation>
    </message>
    <message>
        <source>What is required</source>
        <translation>Was verlangt wird</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Change one of the edges so that they meet as they should</source>
        <translation>Eine der Kanten so ändern, dass sie sich treffen, wie sie sollen</translation>
    </message>
    <message>
        <source>; matched: {}</source>
        <translation>; angepasst: {}</translation>
    </message>
    <message>
        <source>No.</source>
        <extracomment>what is shown: indices of rows, from top to bottom</extracomment>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>The worst join has number 1; the labels in the 3D view say these numbers</source>
        <translation>Der schlechteste Übergang hat die Nummer 1; in der 3D-Ansicht stehen diese Nummern</translation>
    </message>
    <message>
        <source>Order of continuity</source>
        <translation>Ordnung der Stetigkeit</translation>
    </message>
    <message>
        <source>The edges that meet, or the edge with an inner knot</source>
        <translation>Die Kanten, die sich treffen, oder die Kante mit einem inneren Knoten</translation>
    </message>
    <message>
        <source>The next order and what is missed of it; sorted by how many tolerances that is</source>
        <translation>Die nächste Ordnung und was zu ihr fehlt; sortiert danach, wie viele Toleranzen das sind</translation>
    </message>
    <message>
        <source>Deviation of this order</source>
        <translation>Abweichung dieser Ordnung</translation>
    </message>
    <message>
        <source>Joins below this order are out of tolerance</source>
        <extracomment>properties to set, as a dict</extracomment>
        <translation>Übergänge unter dieser Ordnung sind außer Toleranz</translation>
    </message>
    <message>
        <source>all but corners</source>
        <translation>alle außer Ecken</translation>
    </message>
    <message>
        <source>neighbours in a wire</source>
        <translation>Nachbarn im Kantenzug</translation>
    </message>
    <message>
        <source>all pairs</source>
        <translation>alle Paare</translation>
    </message>
    <message>
        <source>Which edges at a vertex are a join</source>
        <translation>Welche Kanten an einem Eckpunkt ein Übergang sind</translation>
    </message>
    <message>
        <source>Tangents that turn by more are a corner</source>
        <translation>Tangenten, die sich um mehr drehen, sind eine Ecke</translation>
    </message>
    <message>
        <source>How far ends of edges in no wire may be apart to be a join; 0: only where they share a vertex</source>
        <translation>Wie weit die Enden von Kanten ohne Kantenzug auseinander sein dürfen, um ein Übergang zu sein; 0: nur wo sie einen Eckpunkt teilen</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Verlangt</translation>
    </message>
    <message>
        <source>Joins are</source>
        <translation>Übergänge sind</translation>
    </message>
    <message>
        <source>Corner from</source>
        <translation>Ecke ab</translation>
    </message>
    <message>
        <source>Ends touch within</source>
        <translation>Enden treffen sich bis</translation>
    </message>
    <message>
        <source>all joins</source>
        <extracomment>properties to set, as a dict</extracomment>
        <translation>alle Übergänge</translation>
    </message>
    <message>
        <source>those out of tolerance</source>
        <translation>die außer Toleranz</translation>
    </message>
    <message>
        <source>How many joins that are out of tolerance have a number, the worst first</source>
        <translation>Wie viele Übergänge außer Toleranz eine Nummer haben, die schlechtesten zuerst</translation>
    </message>
    <message>
        <source>Most numbers</source>
        <translation>Höchstens Nummern</translation>
    </message>
    <message>
        <source>Select objects, and press Take selection: their joins are audited.</source>
        <translation>Wählen Sie Objekte und drücken Sie „Auswahl nehmen“: Deren Übergänge werden geprüft.</translation>
    </message>
    <message>
        <source>The objects must be in one document, {}.</source>
        <translation>Die Objekte müssen in einem Dokument sein, {}.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>{} kann nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <source>The 3D view</source>
        <translation>Die 3D-Ansicht</translation>
    </message>
    <message>
        <source>Worst: {}</source>
        <translation>Am schlechtesten: {}</translation>
    </message>
    <message>
        <source>{} join of {} edges</source>
        <extracomment>how many gaps, G0, G1, ...</extracomment>
        <translation>{} Übergang von {} Kanten</translation>
    </message>
    <message>
        <source>{} joins of {} edges</source>
        <translation>{} Übergänge von {} Kanten</translation>
    </message>
    <message>
        <source>{} below {}</source>
        <translation>{} unter {}</translation>
    </message>
    <message>
        <source>none below {}</source>
        <translation>keiner unter {}</translation>
    </message>
    <message>
        <source>corners left out: {}</source>
        <translation>ausgelassene Ecken: {}</translation>
    </message>
    <message>
        <source>undecided: {}</source>
        <translation>offen: {}</translation>
    </message>
    <message>
        <source>below {}</source>
        <translation>unter {}</translation>
    </message>
    <message>
        <source>out of tolerance (below {})</source>
        <translation>außer Toleranz (unter {})</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>any deviation</source>
        <translation>jede Abweichung</translation>
    </message>
    <message>
        <source>{} at least</source>
        <translation>{} mindestens</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} von {}</translation>
    </message>
    <message>
        <source>An inner knot of one edge: Match changes edges where they meet. Join can smooth it.</source>
        <extracomment>the object of the changed edge, which is nothing but that edge</extracomment>
        <translation>Ein innerer Knoten einer Kante: Anpassen ändert Kanten, wo sie sich treffen. Verbinden kann ihn glätten.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>the worst {} of {} numbered</source>
        <translation>die schlechtesten {} von {} nummeriert</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>OsculatePreferences</name>
    <message>
        <source>Joins</source>
        <translation>Übergänge</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Untersuchung</translation>
    </message>
    <message>
        <source>Tolerance preset</source>
        <translation>Toleranzvorgabe</translation>
    </message>
    <message>
        <source>Analyse up to order</source>
        <translation>Untersuchen bis zur Ordnung</translation>
    </message>
    <message>
        <source>The panel follows the selection</source>
        <translation>Das Fenster folgt der Auswahl</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>In der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Frenet frames</source>
        <translation>Frenet-Dreibeine</translation>
    </message>
    <message>
        <source>Control polygons</source>
        <translation>Kontrollpolygone</translation>
    </message>
    <message>
        <source>Length of the frames</source>
        <translation>Länge der Dreibeine</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>Size of labels</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source> points</source>
        <translation> Punkt</translation>
    </message>
    <message>
        <source>First curve (arriving)</source>
        <translation>Erste Kurve (ankommend)</translation>
    </message>
    <message>
        <source>Second curve (leaving)</source>
        <translation>Zweite Kurve (abgehend)</translation>
    </message>
</context>
<context>
    <name>Osculate_AnalyzeJoin</name>
    <message>
        <source>Analyze join</source>
        <extracomment>In the order of the toolbar and of the menu.</extracomment>
        <translation>Übergang untersuchen</translation>
    </message>
    <message>
        <source>Shows which continuity G0 to G4 two edges have where they meet, and by how much each order misses.
Select two edges, the vertex between them, or a whole wire or sketch.</source>
        <translation>Zeigt, welche Stetigkeit G0 bis G4 zwei Kanten haben, wo sie sich treffen, und um wie viel jede Ordnung verfehlt wird.
Zwei Kanten auswählen, den Punkt zwischen ihnen oder einen ganzen Kantenzug oder eine Skizze.</translation>
    </message>
</context>
<context>
    <name>Osculate_AttachSolid</name>
    <message>
        <source>Attach neighbour</source>
        <extracomment>In the order of the toolbar and of the menu.</extracomment>
        <translation>Nachbarn ansetzen</translation>
    </message>
    <message>
        <source>Makes a Bézier solid that meets the selected one over a face with contact C0, C1, …</source>
        <translation>Erzeugt einen Bézier-Körper, der über einer Fläche mit Kontakt C0, C1, … an den ausgewählten stößt</translation>
    </message>
</context>
<context>
    <name>Osculate_Audit</name>
    <message>
        <source>Audit</source>
        <translation>Prüfung aller Übergänge</translation>
    </message>
    <message>
        <source>Checks all joins of whole objects at once, worst first, with a table, filters and labels; it stays in the document and follows every edit.
Select objects.</source>
        <translation>Prüft alle Übergänge ganzer Objekte auf einmal, die schlechtesten zuerst, mit Tabelle, Filtern und Nummern; die Prüfung bleibt im Dokument und folgt jeder Änderung.
Wählen Sie Objekte.</translation>
    </message>
</context>
<context>
    <name>Osculate_BezierSolid</name>
    <message>
        <source>Bézier solid</source>
        <translation>Bézier-Körper</translation>
    </message>
    <message>
        <source>Makes a rational Bézier tetrahedron: a tetrahedron, a cone, a part of a ball or of a cylinder, exactly, or a random one.</source>
        <translation>Erzeugt ein rationales Bézier-Tetraeder: ein Tetraeder, einen Kegel, einen Teil einer Kugel oder eines Zylinders, exakt, oder ein zufälliges.</translation>
    </message>
</context>
<context>
    <name>Osculate_Blend</name>
    <message>
        <source>Blend</source>
        <translation>Überblenden</translation>
    </message>
    <message>
        <source>Connects two edges by a curve that meets each with its own order of continuity, G0 to G4.
Select two edges, or click first and select then.</source>
        <translation>Verbindet zwei Kanten durch eine Kurve, die jede mit einer eigenen Ordnung der Stetigkeit trifft, G0 bis G4.
Wählen Sie zwei Kanten, oder klicken Sie zuerst und wählen dann.</translation>
    </message>
</context>
<context>
    <name>Osculate_CheckContact</name>
    <message>
        <source>Check contact</source>
        <translation>Kontakt prüfen</translation>
    </message>
    <message>
        <source>Finds the face over which the two selected Bézier solids meet, and the highest C^s there; the check follows them.</source>
        <translation>Findet die Fläche, an der die zwei ausgewählten Bézier-Körper aneinanderstoßen, und das höchste C^s dort; die Prüfung folgt ihnen.</translation>
    </message>
</context>
<context>
    <name>Osculate_CheckValidity</name>
    <message>
        <source>Check validity</source>
        <translation>Gültigkeit prüfen</translation>
    </message>
    <message>
        <source>Proves whether the selected Bézier solids fold over themselves, and shows where.</source>
        <translation>Beweist, ob die ausgewählten Bézier-Körper sich falten, und zeigt, wo.</translation>
    </message>
</context>
<context>
    <name>Osculate_ControlPolygons</name>
    <message>
        <source>Control polygons</source>
        <extracomment>the class of the panel</extracomment>
        <translation>Kontrollpolygone</translation>
    </message>
    <message>
        <source>Draws the control polygon of every Bézier segment of curves, with weights and differences on demand; it stays in the document and follows every edit.
Select edges, faces, sketches or whole objects.</source>
        <translation>Zeichnet das Kontrollpolygon jedes Bézier-Segments von Kurven, auf Wunsch mit Gewichten und Differenzen; es bleibt im Dokument und folgt jeder Änderung.
Kanten, Flächen, Skizzen oder ganze Objekte auswählen.</translation>
    </message>
</context>
<context>
    <name>Osculate_CurvatureComb</name>
    <message>
        <source>Curvature comb</source>
        <translation>Krümmungskamm</translation>
    </message>
    <message>
        <source>Shows curvature, torsion or their rates along curves as a comb, which stays in the document and follows every edit.
Select edges, faces, sketches or whole objects.</source>
        <translation>Zeigt Krümmung, Torsion oder deren Änderung entlang von Kurven als Kamm, der im Dokument bleibt und jeder Änderung folgt.
Wählen Sie Kanten, Flächen, Skizzen oder ganze Objekte.</translation>
    </message>
</context>
<context>
    <name>Osculate_CurvePlot</name>
    <message>
        <source>Curve plot</source>
        <translation>Kurvenverlauf</translation>
    </message>
    <message>
        <source>Plots curvature, torsion and their rates over the arc length of what is selected, with every join and its order.
Select edges, faces, sketches or whole objects.</source>
        <translation>Zeichnet Krümmung, Torsion und ihre Änderungen über der Bogenlänge des Ausgewählten, mit jedem Übergang und seiner Ordnung.
Kanten, Flächen, Skizzen oder ganze Objekte auswählen.</translation>
    </message>
</context>
<context>
    <name>Osculate_ElevateSolid</name>
    <message>
        <source>Raise degree</source>
        <translation>Grad erhöhen</translation>
    </message>
    <message>
        <source>Gives the selected Bézier solids one degree more: they stay as they are and have more control points.</source>
        <translation>Erhöht den Grad der ausgewählten Bézier-Körper um eins: sie bleiben, wie sie sind, und haben mehr Kontrollpunkte.</translation>
    </message>
</context>
<context>
    <name>Osculate_ExportSolid</name>
    <message>
        <source>Export to ParaView</source>
        <translation>Nach ParaView exportieren</translation>
    </message>
    <message>
        <source>Writes the selected Bézier solids into one file for ParaView (.vtu), exactly, with their weights.</source>
        <translation>Schreibt die ausgewählten Bézier-Körper in eine Datei für ParaView (.vtu), exakt, mit ihren Gewichten.</translation>
    </message>
</context>
<context>
    <name>Osculate_Extend</name>
    <message>
        <source>Extend</source>
        <translation>Verlängern</translation>
    </message>
    <message>
        <source>Continues an edge beyond one of its ends with continuity G0 to G4: to a length, a point, a direction, a curvature.
Select the edge near the end, or click first and select then.</source>
        <translation>Setzt eine Kante über eines ihrer Enden hinaus mit Stetigkeit G0 bis G4 fort: bis zu einer Länge, einem Punkt, einer Richtung, einer Krümmung.
Wählen Sie die Kante nahe dem Ende, oder klicken Sie zuerst und wählen dann.</translation>
    </message>
</context>
<context>
    <name>Osculate_Interpolate</name>
    <message>
        <source>Interpolate</source>
        <translation>Interpolieren</translation>
    </message>
    <message>
        <source>Runs a G2 curve through points, with a tension at each.
Select vertices, or an object for all its vertices.</source>
        <translation>Legt eine G2-Kurve durch Punkte, mit einer Spannung an jedem.
Eckpunkte auswählen oder ein Objekt für alle seine Eckpunkte.</translation>
    </message>
</context>
<context>
    <name>Osculate_Join</name>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Makes one B-spline of the edges of a chain, with as few knots as their continuity allows.
Select edges, or a whole wire or sketch.</source>
        <translation>Macht aus den Kanten einer Kette einen B-Spline mit so wenigen Knoten, wie ihre Stetigkeit erlaubt.
Kanten auswählen oder einen ganzen Kantenzug oder eine Skizze.</translation>
    </message>
</context>
<context>
    <name>Osculate_Match</name>
    <message>
        <source>Match</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Changes an edge as little as possible so that it meets another one with continuity G0 to G4.
Select the edge that stays, then the edge that changes, or click first and select then.</source>
        <translation>Ändert eine Kante so wenig wie möglich, sodass sie eine andere mit Stetigkeit G0 bis G4 trifft.
Wählen Sie die Kante, die bleibt, dann die Kante, die sich ändert, oder klicken Sie zuerst und wählen dann.</translation>
    </message>
</context>
<context>
    <name>Osculate_Probe</name>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Moves along curves and shows frame, osculating circle, planes, curvature and torsion, and the construction of de Casteljau; it stays in the document and follows every edit.
Select edges, sketches or whole objects.</source>
        <translation>Wandert Kurven entlang und zeigt Dreibein, Krümmungskreis, Ebenen, Krümmung und Torsion und die Konstruktion von de Casteljau; sie bleibt im Dokument und folgt jeder Änderung.
Kanten, Skizzen oder ganze Objekte auswählen.</translation>
    </message>
</context>
<context>
    <name>Osculate_ProjectSolid</name>
    <message>
        <source>Project from 4D</source>
        <translation>Aus 4D projizieren</translation>
    </message>
    <message>
        <source>Makes the image of the selected Bézier solid of four dimensions in three, parallel or from a point.</source>
        <translation>Erzeugt das Bild des ausgewählten vierdimensionalen Bézier-Körpers in drei Dimensionen, parallel oder von einem Punkt aus.</translation>
    </message>
</context>
<context>
    <name>Osculate_SolidFromPoints</name>
    <message>
        <source>New from points</source>
        <translation>Neu aus Punkten</translation>
    </message>
    <message>
        <source>Makes a Bézier solid of a table of control points and weights, typed, pasted or read from a file.</source>
        <translation>Erzeugt einen Bézier-Körper aus einer Tabelle von Kontrollpunkten und Gewichten, getippt, eingefügt oder aus einer Datei gelesen.</translation>
    </message>
</context>
<context>
    <name>Osculate_SolidToBRep</name>
    <message>
        <source>To B-Rep solid</source>
        <translation>In B-Rep-Körper</translation>
    </message>
    <message>
        <source>Makes Part solids with the exact faces of the selected Bézier solids, which they follow: for booleans, STEP and all that Part can do.</source>
        <translation>Erzeugt Part-Körper mit den exakten Flächen der ausgewählten Bézier-Körper, denen sie folgen: für Boolesche Operationen, STEP und alles, was Part kann.</translation>
    </message>
</context>
<context>
    <name>Osculate_SubdivideSolid</name>
    <message>
        <source>Subdivide</source>
        <translation>Zerlegen</translation>
    </message>
    <message>
        <source>Cuts the selected Bézier solid, exactly: into four around a point, into eight, or into halves.</source>
        <translation>Zerlegt den ausgewählten Bézier-Körper exakt: in vier um einen Punkt, in acht oder in Hälften.</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Osculate</source>
        <translation>Osculate</translation>
    </message>
    <message>
        <source>&amp;Osculate</source>
        <translation>&amp;Osculate</translation>
    </message>
    <message>
        <source>Geometric continuity G0 to G4 of curves, Bézier solids</source>
        <extracomment>notches, positive away from the user</extracomment>
        <translation>Geometrische Stetigkeit G0 bis G4 von Kurven, Bézier-Körper</translation>
    </message>
    <message>
        <source>Bezier solids</source>
        <translation>Bézier-Körper</translation>
    </message>
    <message>
        <source>&amp;Bezier solids</source>
        <translation>&amp;Bézier-Körper</translation>
    </message>
</context>
</TS>
