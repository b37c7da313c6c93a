"""The Teletype beside DEC's flip-flops: IOTs, keys, tape, lever and INITIALIZE by chance.

beside      both, driven together; the first difference
scenes      what is done to them, and when
test_gates  some thousand characters; 100,000 in the slow test
"""
