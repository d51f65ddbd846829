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
        <translation>Höchste untersuchte Ordnung, 0 bis 8</translation>
    </message>
    <message>
        <source>Tolerances of Osculate, of another system, or custom</source>
        <translation>Toleranzen von Osculate, eines anderen Systems oder eigene</translation>
    </message>
    <message>
        <source>Largest distance of the ends that passes G0</source>
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
        <translation>Differenz der Windungen, 1/mm</translation>
    </message>
    <message>
        <source>Difference of the rates of curvature by arc length, 1/mm²</source>
        <translation>Differenz der Krümmungsänderungen nach der Bogenlänge, 1/mm²</translation>
    </message>
    <message>
        <source>The derivative of arc length of this order at the end, by the parameter, as a share of the chord; β1 is the speed</source>
        <extracomment>(N, K+1): bounds of the errors of the residuals</extracomment>
        <translation>Die Ableitung dieser Ordnung der Bogenlänge nach dem Parameter am Ende, als Anteil der Sehne; β1 ist die Geschwindigkeit</translation>
    </message>
    <message>
        <source>Whether the number is given; else it is chosen at each recompute</source>
        <extracomment>the JoinReport at its far end, where it can be told</extracomment>
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
        <extracomment>What a construction raises where it cannot be made; the message is a sentence for the user.</extracomment>
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
</context>
<context>
    <name>Osculate</name>
    <message>
        <source>No edge is linked (its object was deleted?).</source>
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
        <extracomment>An end that meets no other is joined with those within this multiple of the gap tolerance.</extracomment>
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
        <extracomment>open while the object is edited</extracomment>
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
        <extracomment>the properties that link to them</extracomment>
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
        <translation>Windung</translation>
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
        <extracomment>name of an icon of resources/icons</extracomment>
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
        <extracomment>why it failed</extracomment>
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
        <extracomment>index of the edge that the next click gives, None: no edge</extracomment>
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
        <translation>Die Kanten müssen in einem Dokument liegen, {}.</translation>
    </message>
    <message>
        <source>There is nothing to keep yet: mend what is wrong, or Cancel.</source>
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
    <name>Osculate_Extend</name>
    <message>
        <source>Extend</source>
        <extracomment>the class of the ConstructPanel</extracomment>
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
    <name>Workbench</name>
    <message>
        <source>Geometric continuity G0 to G4 of curves</source>
        <translation>Geometrische Stetigkeit G0 bis G4 von Kurven</translation>
    </message>
    <message>
        <source>Osculate</source>
        <translation>Osculate</translation>
    </message>
    <message>
        <source>&amp;Osculate</source>
        <translation>&amp;Osculate</translation>
    </message>
</context>
</TS>
