"""The generated test suite: facts and cases as data, and the checks that read them."""
