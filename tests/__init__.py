"""The tests mirror the packages; test_chain is the main job, test_arrows imports, test_readme the docs."""
