"""NC programs that undo a machine's geometric errors (Sect. 5 of the paper).

A program goes through these stages, a bounded batch of blocks at a time:

    files       bytes of a program <-> lines; the output is put in place whole or not at all. dialects: what a program
                says of itself: its language, and the mark by which a compensated one is refused a second time
    nc, klartext, apt
                lines -> items (moves): text that moves nothing, and moves; what is not followed is a fault. Each has a
                reader. Of nc: runs (most blocks, many at once, by plain_text; their arcs by run_arcs), lexer (words;
                siemens for SINUMERIK), block (what they ask for, by g_codes and m_codes), modes, frame_codes (work
                offsets), tool_codes, motion, cycles (what holes become: cycle_blocks); state: modes in force, and which
                axes the program has put where they stand (tool changes and stops undo it); the others are held: they
                get no word, nor does one that was commanded in another frame
    linuxcnc    LinuxCNC's interpreter unrolls a program first: interpreter has it run calls, and makes blocks of them
    columns     moves read together, and arcs, many at once
    offsets, tools
                what is known of the control before, and the files that say it. nc.frames: what is in force
    path        moves -> points; arcs become chords within the chord tolerance
    tracker     with effects: which act, and a point of its own where a reversal makes the commands jump; course: how
                the axes come and go along the path, and the machine at each place of it
    subdivide   a program is divided into batches, and lines where the errors along them are not straight enough
    solve       Eqs. (55), (56): commands that bring the tool where an error-free machine would, by the linear axes or,
                the tool axis too, by all
    executed    commands -> words (lattice): nearest, or chosen along the ball bar (word_choice); kept_arcs: chords are
                joined to arcs again
    writer      moves -> blocks with new axis words; run_text: many at once
    elsewhere   what axes and work offsets that are somewhere else change
    reliance    the places that the program came to, and how far it relies there on what was measured
    program     all of it; tally: the figures of the report; sign_check: what to compare with the machine before use

Moves are in axis positions (machine coordinates), words in the frame of the program. The solver leaves less than a
hundredth of the tolerance; what is left of the error after it is the rounding of words. With words of 0.001 mm, |E| of
Eq. (6) is then

    words     mean |E|, mm (bar anywhere / in XY)    blocks       why no better
    nearest   0.00024 / 0.00024                      as given     the paper's result: 0.000244
    ends      0.00012 / 0.00017                      as given     4.2 lattice points within one step: all are tried
    middles   0.00004 / 0.00006                      twice        half lattice; 0.00002 / 0.00005 if the ends of short
                                                                  blocks did not matter

with error vectors of at most 0.00087, 0.001 and 0.001 mm.
"""
