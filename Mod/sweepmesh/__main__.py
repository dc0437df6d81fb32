"""The command line: python -m sweepmesh SHAPE [options]."""

from sweepmesh.cli.main import main

if __name__ == "__main__":
    main()
