# Play vectors for hands on a PDP-8/L, by pipan8l of github.com/mrieker/pdp8l: pipan8l hands.tcl
#
# The machine needs no paper: the Teletype on line, its reader's lever at STOP, nobody at its keys. A hand takes a quarter
# of a second, all of them some hours. What differs is printed as it comes, then how many vectors differ.

set vectors 0
set differ 0

proc vector {name} {
    global title hands vectors wrong
    set title $name
    set hands 0
    set wrong 0
    incr vectors
    setsw mprt 0
    setsw step 0
    flicksw stop
}

proc word {address word} {
    wrmem $address $word
    same "core [format %04o $address], as it was put there," [getreg mb] $word
}

# Do one thing; then compare the lamps that are named: ma 0201 mb 07402 ...
proc hand {what value lamps} {
    global hands
    incr hands
    switch $what {
        sr - step - mprt {setsw $what $value}
        run {for {set n 0} {$n < 20 && [getreg run]} {incr n} {after 100; flushit}}
        default {flicksw $what}
    }
    flushit
    foreach {lamp meant} $lamps {same "$lamp after hand $hands, $what," [getreg $lamp] $meant}
}

proc core {address word} {
    setsw step 0
    same "core [format %04o $address]" [rdmem $address] $word
}

# Note a difference; a vector tells its first one.
proc same {what got meant} {
    global title differ wrong
    if {$wrong || $got eq $meant || ([string is integer -strict $got] && $got == $meant)} return
    set wrong 1
    incr differ
    if {[string is integer -strict $got]} {set got [format %o $got]; set meant [format %o $meant]}
    puts "$title: $what is '$got', not '$meant'"
}

proc summary {} {
    global vectors differ
    puts "$vectors played, $differ differ"
}

